#include "app/host/frames/frame_files.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>
#include <vector>

#include "app/host/frames/recorder.hpp"
#include "app/session/output/json.hpp"
#include "app/session/wording/messages.hpp"
#include "render/files/atomic_file.hpp"
#include "render/files/png.hpp"

namespace jw::host {

namespace {

std::set<std::string> names_of(int first, int last) {
    std::set<std::string> names;
    for (int number = first; number <= last; ++number) { names.insert(frame_name(number)); }
    return names;
}

namespace fs = std::filesystem;

constexpr const char* kManifest = "manifest.json";
constexpr const char* kUnfinished = "unfinished.json";
constexpr const char* kDrawn = "unfinished-frames";

/// Pictures that a manifest of the program names; none if the file is cut off.
/// @throws std::runtime_error if the file is of other origin or version
std::set<std::string> named_in(const fs::path& path, bool must_be_ours) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) { return {}; }
    if (!fs::is_regular_file(status)) {
        refuse(path, "is not a regular file; expected a folder that is only for pictures");
    }
    std::ifstream in(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const Json json = Json::parse(text, nullptr, false);
    if (json.is_discarded()) { return {}; }
    const auto format = json.is_object() ? json.find("format") : json.end();
    if (format == json.end() || *format != "jointwise render") {
        if (!must_be_ours) { return {}; }
        refuse(
            path,
            "is not a manifest of pictures, and would be overwritten; expected a folder that is only for "
            "pictures");
    }
    if (const Json version = json.value("version", Json(kJsonVersion)); version != kJsonVersion) {
        refuse(
            path, "has the version " + version.dump() + "; this program reads " +
                      std::to_string(kJsonVersion) +
                      ", so it does not know which pictures are those of the folder");
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

void put_in_place(const fs::path& from, const fs::path& to) {
    std::error_code error;
    fs::rename(from, to, error);
    if (error) { refuse(to, "cannot be replaced: " + error.message()); }
}

class FolderRecorder : public Recorder {
public:
    FolderRecorder(std::filesystem::path folder, int first, int last)
        : folder_(std::move(folder)), files_(folder_, first, last) {}

    void add(int number, const View& view, double seconds, render::Image image) override {
        files_.add(number, view, seconds, std::move(image));
        ++count_;
    }
    std::string finish(Json head) override {
        files_.finish(std::move(head));
        return tr_count(
            count_, "{0} picture and manifest.json in {1}", "{0} pictures and manifest.json in {1}",
            folder_.string());
    }

private:
    std::filesystem::path folder_;
    FrameFiles files_;
    int count_ = 0;
};

}  // namespace

void PictureWriter::add(int number, render::Image image) {
    wait();
    writing_ = std::async(
        std::launch::async, [this, path = folder_ / frame_name(number), picture = std::move(image)] {
            render::write_file_atomically(path, encoder_.encode(picture));
        });
}

void PictureWriter::wait() {
    if (writing_.valid()) { writing_.get(); }
}

Json entry_of(int number, const View& view, double seconds) {
    const bool motion = view.kind == Step::Kind::motion;
    return {
        {"file", frame_name(number)},
        {"frame", number},
        {"kind", kind_name(view.kind)},
        {"step", motion ? Json() : Json(view.step)},
        {"time_s", view.t},
        {"seconds", seconds},
        {"title", view.title},
        {"sentence", view.sentence},
        {"rows", view.rank.rows},
        {"columns", view.rank.columns},
        {"rank", view.rank.rank},
        {"dof", view.rank.dof},
        {"residual", view.rank.residual}};
}

FrameFiles::FrameFiles(
    const std::filesystem::path& folder, int first, int last, const std::filesystem::path& lesson)
    : folder_(folder, names_of(first, last), lesson), writer_(folder_.draft().folder()) {}

void FrameFiles::add(int number, const View& view, double seconds, render::Image image) {
    if (!draft().is_begun()) { draft().begin({{"format", "jointwise run"}}); }
    writer_.add(number, std::move(image));
    add_drawn(number, view, seconds);
}

void FrameFiles::add_drawn(int number, const View& view, double seconds) {
    frames_.push_back(entry_of(number, view, seconds));
}

void FrameFiles::finish(Json head) {
    writer_.wait();
    if (!draft().is_begun()) { draft().begin({{"format", "jointwise run"}}); }
    for (Json& frame : frames_) {
        frame["sha256"] = sha256_of(draft().folder() / frame["file"].get<std::string>());
    }
    head["frames"] = std::move(frames_);
    folder_.finish(json_document(head));
}

FrameFolder::FrameFolder(fs::path folder, std::set<std::string> names, const fs::path& keep)
    : folder_(std::move(folder)), draft_(draft_folder(folder_)), names_(std::move(names)) {
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error || !fs::is_directory(folder_, error)) {
        refuse(
            folder_, "cannot be made a folder" + (error ? ": " + error.message() : "") +
                         "; expected a folder that can be written");
    }
    // another run may be replacing pictures: each picture that exists now is in one of these lists
    const std::vector<std::string> there = names_in(folder_);
    before_ = named_in(folder_ / kManifest, true);
    before_.merge(named_in(folder_ / kUnfinished, false));
    before_.merge(named_in(folder_ / kManifest, true));
    if (!keep.empty()) { protect(keep); }
    refuse_strangers(there);
}

fs::path FrameFolder::draft_folder(const fs::path& folder) { return folder / kDrawn; }

void FrameFolder::refuse_strangers(const std::vector<std::string>& names) const {
    for (const std::string& name : names) {
        if (!is_frame_name(name) || before_.contains(name)) { continue; }
        refuse(
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
            refuse(folder_ / name, "is the lesson that is drawn; expected another folder");
        }
    }
}

void FrameFolder::remove(const std::string& name) const {
    std::error_code error;
    fs::remove(folder_ / name, error);
    if (error) { refuse(folder_ / name, "cannot be removed: " + error.message()); }
}

void FrameFolder::finish(const std::string& manifest) {
    // another run may have ended in the meantime
    before_.merge(named_in(folder_ / kManifest, true));
    const fs::path& drawn_in = draft_.folder();
    render::write_file_atomically(drawn_in / kManifest, manifest);
    std::vector<std::string> drawn = names_in(drawn_in);
    std::erase_if(drawn, [this](const std::string& name) { return !names_.contains(name); });

    // lists the pictures while they are replaced, in case the replacement is interrupted
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
    for (const std::string& name : drawn) { put_in_place(drawn_in / name, folder_ / name); }
    for (const std::string& name : before_) {
        if (!std::ranges::binary_search(drawn, name)) { remove(name); }
    }
    put_in_place(drawn_in / kManifest, folder_ / kManifest);
    remove(kUnfinished);
    draft_.clear();
}

std::unique_ptr<Recorder> make_recorder(const std::filesystem::path& path, int first, int last) {
    return std::make_unique<FolderRecorder>(path, first, last);
}

}  // namespace jw::host
