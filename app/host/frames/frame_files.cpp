#include "app/host/frames/frame_files.hpp"

#include <set>

#include "app/session/output/json.hpp"
#include "render/files/atomic_file.hpp"
#include "render/files/png.hpp"

namespace jw::host {

namespace {

std::set<std::string> names_of(int first, int last) {
    std::set<std::string> names;
    for (int number = first; number <= last; ++number) { names.insert(frame_name(number)); }
    return names;
}

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

}  // namespace jw::host
