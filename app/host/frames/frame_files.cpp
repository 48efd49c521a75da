#include "app/host/frames/frame_files.hpp"

#include <array>
#include <cstdio>
#include <set>

#include "app/session/output/json.hpp"
#include "render/atomic_file.hpp"
#include "render/png.hpp"

namespace jw::host {

std::string frame_name(int number) {
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "frame_%05d.png", number);
    return name.data();
}

namespace {

std::set<std::string> names_of(int first, int last) {
    std::set<std::string> names;
    for (int number = first; number <= last; ++number) { names.insert(frame_name(number)); }
    return names;
}

}  // namespace

FrameFiles::FrameFiles(
    const std::filesystem::path& folder, int first, int last, const std::filesystem::path& lesson)
    : folder_(folder, names_of(first, last), lesson) {}

void FrameFiles::wait() {
    if (!writing_.valid()) { return; }
    writing_.get();
}

void FrameFiles::add(int number, const View& view, double seconds, render::Image image) {
    if (frames_.empty()) { folder_.begin(); }
    wait();
    writing_ = std::async(
        std::launch::async, [path = folder_.drawn() / frame_name(number), picture = std::move(image)] {
            render::write_file_atomically(path, render::encode_png(picture));
        });
    const bool motion = view.kind == Step::Kind::motion;
    frames_.push_back(
        {{"file", frame_name(number)},
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
         {"residual", view.rank.residual}});
}

void FrameFiles::finish(Json head) {
    wait();
    head["frames"] = std::move(frames_);
    folder_.finish(json_document(head));
}

}  // namespace jw::host
