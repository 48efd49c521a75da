#include "app/snapshot/golden_folder.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "render/files/atomic_file.hpp"
#include "render/files/png.hpp"
#include "render/files/png_reader.hpp"

namespace jw::snapshot {

namespace {

namespace fs = std::filesystem;

constexpr const char* kHead = "snapshots.json";
constexpr const char* kLesson = "lesson.toml";
constexpr const char* kFolderFormat = "jointwise snapshots";
constexpr int kFolderVersion = 1;
// unpacked data are many times larger; records have about 0.05 MB, pictures at most 25 MB
constexpr std::uintmax_t kLargestText = 1U << 23U;
constexpr std::uintmax_t kLargestPng = 1U << 26U;
constexpr int kMostMoments = 1000;

constexpr const char* kRecord = ".json";
constexpr const char* kColour = ".png";
constexpr const char* kIds = ".ids.png";
constexpr const char* kDepth = ".depth.png";

[[noreturn]] void unreadable(const fs::path& path, const std::string& why) {
    throw std::runtime_error(
        "'" + path.string() + "' cannot be read" + why +
        "; expected a file of a snapshot (restore it, or remove the snapshot and record it again)");
}

std::vector<std::uint8_t> bytes_of(const fs::path& path, std::uintmax_t largest) {
    std::error_code error;
    const std::uintmax_t size = fs::file_size(path, error);
    // checked before it is opened: opening a pipe would wait for ever
    if (error) { unreadable(path, ": " + error.message()); }
    std::ifstream in(path, std::ios::binary);
    if (!in) { unreadable(path, ""); }
    if (size > largest) {
        throw std::runtime_error("'" + path.string() + "' is too large for a file of a snapshot");
    }
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string text_at(const fs::path& path) {
    const std::vector<std::uint8_t> bytes = bytes_of(path, kLargestText);
    return {bytes.begin(), bytes.end()};
}

[[noreturn]] void damaged(const fs::path& path, const std::string& why) {
    throw std::runtime_error(
        "'" + path.string() + "' " + why + "; expected a file that 'jointwise snapshot record' has written");
}

int whole_number(const Json& json, const fs::path& path, int least, int most) {
    if (!json.is_number_integer()) { damaged(path, "has a value that is not a whole number"); }
    const auto value = json.get<std::int64_t>();
    if (value < least || value > most) { damaged(path, "has a number out of range"); }
    return static_cast<int>(value);
}

std::string text_of(const SnapshotSize& size) {
    return std::to_string(size.width) + "x" + std::to_string(size.height);
}

/// Reads a picture that must have this size: pictures of other sizes are not even decoded.
render::Image picture_at(const fs::path& path, const SnapshotSize& size) {
    const std::vector<std::uint8_t> bytes = bytes_of(path, kLargestPng);
    const auto [width, height] = render::size_of_png(bytes, path.string());
    if (SnapshotSize{width, height} != size) {
        throw std::runtime_error(
            "'" + path.string() + "' is " + text_of(SnapshotSize{width, height}) + "; expected " +
            text_of(size) + " as " + kHead + " says");
    }
    return render::decode_png(bytes, path.string());
}

}  // namespace

fs::path GoldenFolder::file(const std::string& name, const char* ending) const {
    return folder_ / (name + ending);
}

bool GoldenFolder::exists() const {
    std::error_code error;
    return fs::exists(folder_ / kHead, error);
}

GoldenHead GoldenFolder::head() const {
    const fs::path path = folder_ / kHead;
    const Json json = Json::parse(text_at(path), nullptr, false);
    if (json.is_discarded() || !json.is_object()) { damaged(path, "is no JSON, or cut off"); }
    if (json.value("format", Json()) != kFolderFormat) { damaged(path, "is another file"); }
    if (json.value("version", Json()) != kFolderVersion) {
        damaged(
            path,
            "has a version that this program does not know; it reads " + std::to_string(kFolderVersion));
    }
    const Json size = json.value("size", Json());
    const Json language = json.value("language", Json());
    if (!size.is_array() || size.size() != 2 || !language.is_string()) {
        damaged(path, "lacks \"size\" or \"language\"");
    }
    GoldenHead head;
    head.size = {
        whole_number(size[0], path, kSmallestSize.width, kLargestSize.width),
        whole_number(size[1], path, kSmallestSize.height, kLargestSize.height)};
    head.choice.moments = whole_number(json.value("moments", Json()), path, 0, kMostMoments);
    for (const Json& name : json.value("only", Json::array())) {
        if (!name.is_string()) { damaged(path, "has a value that is not a name"); }
        head.choice.only.push_back(name.get<std::string>());
    }
    head.language = language.get<std::string>();
    return head;
}

std::string GoldenFolder::lesson() const {
    std::error_code error;
    return fs::exists(folder_ / kLesson, error) ? text_at(folder_ / kLesson) : std::string();
}

std::vector<std::string> GoldenFolder::names() const {
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator entry(folder_, error); !error && entry != fs::directory_iterator();
         entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (name == kHead || !name.ends_with(kRecord)) { continue; }
        names.push_back(name.substr(0, name.size() - std::string(kRecord).size()));
    }
    std::ranges::sort(names);
    return names;
}

bool GoldenFolder::has(const std::string& name) const {
    std::error_code error;
    return fs::exists(file(name, kRecord), error);
}

Snapshot GoldenFolder::read(const std::string& name) const {
    Snapshot snapshot;
    const fs::path record = file(name, kRecord);
    snapshot.record = record_of(text_at(record), record.string());
    if (snapshot.record.name != name) { damaged(record, "is the record of another snapshot"); }
    const SnapshotSize size = head().size;
    snapshot.colour = picture_at(file(name, kColour), size);
    snapshot.layers.ids = picture_at(file(name, kIds), size);
    snapshot.layers.depth = picture_at(file(name, kDepth), size);
    snapshot.layers.things = snapshot.record.things;
    return snapshot;
}

std::vector<std::string> GoldenFolder::recorded_below(const fs::path& golden) {
    std::vector<std::string> lessons;
    std::error_code error;
    for (fs::recursive_directory_iterator entry(golden, error);
         !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
        if (entry->path().filename() != kHead) { continue; }
        lessons.push_back(entry->path().parent_path().lexically_relative(golden).generic_string());
    }
    std::ranges::sort(lessons);
    return lessons;
}

bool GoldenFolder::is_copy_of_lesson(const fs::path& file) {
    return file.filename() == kLesson && GoldenFolder(file.parent_path()).exists();
}

void GoldenFolder::write_head(const GoldenHead& head, const std::string& lesson_text) const {
    fs::create_directories(folder_);
    write_lesson(lesson_text);
    const Json json{{"format", kFolderFormat},
                    {"version", kFolderVersion},
                    {"size", {head.size.width, head.size.height}},
                    {"moments", head.choice.moments},
                    {"only", head.choice.only},
                    {"language", head.language}};
    render::write_file_atomically(folder_ / kHead, json_document(json));
}

void GoldenFolder::write_lesson(const std::string& lesson_text) const {
    render::write_file_atomically(folder_ / kLesson, lesson_text);
}

void GoldenFolder::write(const Snapshot& snapshot) const {
    const std::string& name = snapshot.record.name;
    const std::string record = text_of(snapshot.record);
    const std::vector<std::uint8_t> colour = render::encode_png(snapshot.colour);
    const std::vector<std::uint8_t> ids = render::encode_png(snapshot.layers.ids);
    const std::vector<std::uint8_t> depth = render::encode_png(snapshot.layers.depth);
    std::array<render::WholeFile, 4> files{
        {{file(name, kColour), colour},
         {file(name, kIds), ids},
         {file(name, kDepth), depth},
         {file(name, kRecord), render::bytes_of(record)}}};
    if (has(name)) { std::ranges::rotate(files, files.end() - 1); }
    render::write_files_atomically(files);
}

void GoldenFolder::remove(const std::string& name) const {
    for (const char* const ending : {kRecord, kColour, kIds, kDepth}) { fs::remove(file(name, ending)); }
}

void GoldenFolder::remove_lesson(const fs::path& golden) const {
    for (const std::string& name : names()) { remove(name); }
    fs::remove(folder_ / kLesson);
    // last, so that a lesson that is removed only in part is found again
    fs::remove(folder_ / kHead);
    for (fs::path empty = folder_; empty != golden; empty = empty.parent_path()) {
        std::error_code error;
        if (!fs::is_empty(empty, error) || error) { return; }
        fs::remove(empty, error);
    }
}

}  // namespace jw::snapshot
