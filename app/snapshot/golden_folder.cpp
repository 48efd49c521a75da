#include "app/snapshot/golden_folder.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "render/atomic_file.hpp"
#include "render/png.hpp"
#include "render/png_reader.hpp"

namespace jw::snapshot {

namespace {

namespace fs = std::filesystem;

constexpr const char* kHead = "snapshots.json";
constexpr const char* kLesson = "lesson.toml";
constexpr const char* kFormat = "jointwise snapshots";
constexpr int kVersion = 1;
constexpr std::uintmax_t kLargestFile = 1U << 28U;

constexpr const char* kRecord = ".json";
constexpr const char* kColour = ".png";
constexpr const char* kIds = ".ids.png";
constexpr const char* kDepth = ".depth.png";

std::vector<std::uint8_t> bytes_of(const fs::path& path) {
    std::error_code error;
    const std::uintmax_t size = fs::file_size(path, error);
    std::ifstream in(path, std::ios::binary);
    if (error || !in) {
        throw std::runtime_error(
            "'" + path.string() + "' cannot be read" + (error ? ": " + error.message() : "") +
            "; expected a file of a snapshot (restore it, or remove the snapshot and record it again)");
    }
    if (size > kLargestFile) {
        throw std::runtime_error("'" + path.string() + "' is too large for a file of a snapshot");
    }
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string text_at(const fs::path& path) {
    const std::vector<std::uint8_t> bytes = bytes_of(path);
    return {bytes.begin(), bytes.end()};
}

[[noreturn]] void damaged(const fs::path& path, const std::string& why) {
    throw std::runtime_error(
        "'" + path.string() + "' " + why + "; expected a file that 'jointwise snapshot record' has written");
}

int whole_number(const Json& json, const fs::path& path, int least, int most) {
    if (!json.is_number_integer()) { damaged(path, "has something else in place of a whole number"); }
    const auto value = json.get<std::int64_t>();
    if (value < least || value > most) { damaged(path, "has a number out of range"); }
    return static_cast<int>(value);
}

render::Image picture_at(const fs::path& path) { return render::decode_png(bytes_of(path), path.string()); }

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
    if (json.value("format", Json()) != kFormat) { damaged(path, "is another file"); }
    if (json.value("version", Json()) != kVersion) {
        damaged(path, "has a version that this program does not know");
    }
    const Json size = json.value("size", Json());
    const Json language = json.value("language", Json());
    if (!size.is_array() || size.size() != 2 || !language.is_string()) {
        damaged(path, "lacks \"size\" or \"language\"");
    }
    GoldenHead head;
    head.size = {
        whole_number(size[0], path, 1, render::kLargestPicture),
        whole_number(size[1], path, 1, render::kLargestPicture)};
    head.choice.moments = whole_number(json.value("moments", Json()), path, 0, 100000);
    for (const Json& name : json.value("only", Json::array())) {
        if (!name.is_string()) { damaged(path, "has something else in place of a name"); }
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
    snapshot.colour = picture_at(file(name, kColour));
    snapshot.layers.ids = picture_at(file(name, kIds));
    snapshot.layers.depth = picture_at(file(name, kDepth));
    snapshot.layers.things = snapshot.record.things;
    return snapshot;
}

bool GoldenFolder::is_copy_of_lesson(const fs::path& file) {
    return file.filename() == kLesson && GoldenFolder(file.parent_path()).exists();
}

void GoldenFolder::write_head(const GoldenHead& head, const std::string& lesson_text) const {
    fs::create_directories(folder_);
    write_lesson(lesson_text);
    const Json json{
        {"format", kFormat},
        {"version", kVersion},
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
    render::write_file_atomically(file(name, kColour), render::encode_png(snapshot.colour));
    render::write_file_atomically(file(name, kIds), render::encode_png(snapshot.layers.ids));
    render::write_file_atomically(file(name, kDepth), render::encode_png(snapshot.layers.depth));
    render::write_file_atomically(file(name, kRecord), text_of(snapshot.record));
}

void GoldenFolder::remove(const std::string& name) const {
    for (const char* const ending : {kRecord, kColour, kIds, kDepth}) { fs::remove(file(name, ending)); }
}

}  // namespace jw::snapshot
