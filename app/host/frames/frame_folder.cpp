#include "app/host/frames/frame_folder.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "app/session/output/json.hpp"
#include "render/atomic_file.hpp"

namespace jw::host {

namespace {

namespace fs = std::filesystem;

constexpr const char* kManifest = "manifest.json";
constexpr const char* kUnfinished = "unfinished.json";

/// "frame_00042.png", and nothing that leads out of the folder.
bool is_frame_name(const std::string& name) {
    constexpr std::string_view begin = "frame_";
    constexpr std::string_view end = ".png";
    if (!name.starts_with(begin) || !name.ends_with(end) || name.size() < begin.size() + end.size() + 5) {
        return false;
    }
    const std::string digits = name.substr(begin.size(), name.size() - begin.size() - end.size());
    return digits.find_first_not_of("0123456789") == std::string::npos;
}

[[noreturn]] void fail(const fs::path& path, const std::string& why) {
    throw std::runtime_error("'" + path.string() + "' " + why);
}

/// The pictures that a list of ours names. A file that is cut off names none.
/// @throws std::runtime_error if it is somebody else's
std::set<std::string> named_in(const fs::path& path, bool must_be_ours) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) { return {}; }
    if (!fs::is_regular_file(status)) { fail(path, "is no file; expected a folder for pictures alone"); }
    std::ifstream in(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const Json json = Json::parse(text, nullptr, false);
    if (json.is_discarded()) { return {}; }
    const auto format = json.is_object() ? json.find("format") : json.end();
    if (format == json.end() || *format != "jointwise render") {
        if (!must_be_ours) { return {}; }
        fail(
            path,
            "is no manifest of pictures, and would be overwritten; expected a folder for pictures alone");
    }
    std::set<std::string> names;
    const auto frames = json.find("frames");
    if (frames == json.end() || !frames->is_array()) { return names; }
    for (const Json& frame : *frames) {
        const auto file = frame.is_object() ? frame.find("file") : frame.end();
        if (file == frame.end() || !file->is_string()) { continue; }
        const std::string name = file->get<std::string>();
        if (is_frame_name(name)) { names.insert(name); }
    }
    return names;
}

}  // namespace

FrameFolder::FrameFolder(fs::path folder, std::set<std::string> names, const fs::path& keep)
    : folder_(std::move(folder)), names_(std::move(names)) {
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error || !fs::is_directory(folder_, error)) {
        fail(
            folder_, "cannot be made a folder" + (error ? ": " + error.message() : "") +
                         "; expected a folder that can be written");
    }
    std::set<std::string> before = named_in(folder_ / kManifest, true);
    before.merge(named_in(folder_ / kUnfinished, false));
    std::ranges::set_difference(before, names_, std::inserter(stale_, stale_.end()));
    if (!keep.empty()) { protect(keep); }
}

void FrameFolder::protect(const fs::path& keep) const {
    std::error_code error;
    for (fs::directory_iterator entry(folder_, error); !error && entry != fs::directory_iterator();
         entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        const bool ours =
            names_.contains(name) || stale_.contains(name) || name == kManifest || name == kUnfinished;
        std::error_code ignored;
        if (ours && fs::equivalent(entry->path(), keep, ignored)) {
            fail(entry->path(), "is the lesson that is drawn; expected another folder");
        }
    }
}

void FrameFolder::remove(const std::string& name) const {
    std::error_code error;
    fs::remove(folder_ / name, error);
    if (error) { fail(folder_ / name, "cannot be removed: " + error.message()); }
}

void FrameFolder::begin() {
    Json list = Json::array();
    for (const auto& names : {names_, stale_}) {
        for (const std::string& name : names) { list.push_back({{"file", name}}); }
    }
    const Json unfinished{
        {"format", "jointwise render"},
        {"version", kJsonVersion},
        {"unfinished", true},
        {"frames", std::move(list)}};
    render::write_file_atomically(folder_ / kUnfinished, unfinished.dump() + '\n');
    remove(kManifest);
    for (const std::string& name : stale_) { remove(name); }
}

void FrameFolder::finish(const std::string& manifest) {
    render::write_file_atomically(folder_ / kManifest, manifest);
    remove(kUnfinished);
}

}  // namespace jw::host
