#include "app/host/frames/frame_folder.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

#include "app/session/output/json.hpp"
#include "render/atomic_file.hpp"

namespace jw::host {

namespace {

namespace fs = std::filesystem;

constexpr const char* kManifest = "manifest.json";
constexpr const char* kUnfinished = "unfinished.json";
constexpr const char* kDrawn = "unfinished-frames";

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

/// Names in a folder; none if it cannot be read.
std::vector<std::string> names_in(const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error)) {
        names.push_back(entry->path().filename().string());
    }
    std::ranges::sort(names);
    return names;
}

void put_in_place(const fs::path& from, const fs::path& to) {
    std::error_code error;
    fs::rename(from, to, error);
    if (error) { fail(to, "cannot be replaced: " + error.message()); }
}

}  // namespace

FrameFolder::FrameFolder(fs::path folder, std::set<std::string> names, const fs::path& keep)
    : folder_(std::move(folder)), drawn_(folder_ / kDrawn), names_(std::move(names)) {
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error || !fs::is_directory(folder_, error)) {
        fail(
            folder_, "cannot be made a folder" + (error ? ": " + error.message() : "") +
                         "; expected a folder that can be written");
    }
    before_ = named_in(folder_ / kManifest, true);
    before_.merge(named_in(folder_ / kUnfinished, false));
    if (!keep.empty()) { protect(keep); }
    refuse_strangers();
}

FrameFolder::~FrameFolder() {
    if (is_open_) { clear_drawn(); }
}

void FrameFolder::refuse_strangers() const {
    for (const std::string& name : names_in(folder_)) {
        if (!is_frame_name(name) || before_.contains(name)) { continue; }
        fail(
            folder_ / name,
            "is a picture that no manifest in this folder names; expected a folder for the "
            "pictures of one run alone (move it away, or give another folder)");
    }
}

void FrameFolder::protect(const fs::path& keep) const {
    for (const std::string& name : names_in(folder_)) {
        const bool ours =
            names_.contains(name) || before_.contains(name) || name == kManifest || name == kUnfinished;
        std::error_code ignored;
        if (ours && fs::equivalent(folder_ / name, keep, ignored)) {
            fail(folder_ / name, "is the lesson that is drawn; expected another folder");
        }
    }
}

void FrameFolder::remove(const std::string& name) const {
    std::error_code error;
    fs::remove(folder_ / name, error);
    if (error) { fail(folder_ / name, "cannot be removed: " + error.message()); }
}

/// Removes pictures that were drawn and are not in their place; other files in that folder stay, and the
/// folder with them.
void FrameFolder::clear_drawn() const {
    std::error_code ignored;
    if (fs::is_symlink(drawn_, ignored)) { return; }
    for (const std::string& name : names_in(drawn_)) {
        const std::string whole = name.substr(0, name.find(".part-"));
        if (is_frame_name(whole) || whole == kManifest) { fs::remove(drawn_ / name, ignored); }
    }
    fs::remove(drawn_, ignored);
}

void FrameFolder::begin() {
    clear_drawn();
    std::error_code error;
    if (!fs::create_directory(drawn_, error)) {
        fail(
            drawn_, error
                        ? "cannot be made a folder: " + error.message()
                        : "is in the way, with files of somebody else; expected a folder for pictures alone");
    }
    is_open_ = true;
}

void FrameFolder::finish(const std::string& manifest) {
    if (!is_open_) { begin(); }
    render::write_file_atomically(drawn_ / kManifest, manifest);
    std::vector<std::string> drawn = names_in(drawn_);
    std::erase(drawn, kManifest);

    // what is there while places are taken, should that be interrupted
    std::set<std::string> all = before_;
    all.insert(drawn.begin(), drawn.end());
    Json list = Json::array();
    for (const std::string& name : all) { list.push_back({{"file", name}}); }
    const Json unfinished{
        {"format", "jointwise render"},
        {"version", kJsonVersion},
        {"unfinished", true},
        {"frames", std::move(list)}};
    render::write_file_atomically(folder_ / kUnfinished, json_document(unfinished, -1));

    remove(kManifest);
    for (const std::string& name : drawn) { put_in_place(drawn_ / name, folder_ / name); }
    for (const std::string& name : before_) {
        if (!std::ranges::binary_search(drawn, name)) { remove(name); }
    }
    put_in_place(drawn_ / kManifest, folder_ / kManifest);
    remove(kUnfinished);
    clear_drawn();
    is_open_ = false;
}

}  // namespace jw::host
