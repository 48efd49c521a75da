#include "app/host/frame_files.hpp"

#include <array>
#include <cstdio>
#include <span>

#include "app/session/json.hpp"
#include "render/png.hpp"

namespace jw::host {

std::string frame_name(int number) {
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "frame_%05d.png", number);
    return name.data();
}

FrameFiles::FrameFiles(std::filesystem::path folder) : folder_(std::move(folder)) {
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    if (error || !std::filesystem::is_directory(folder_)) {
        throw std::runtime_error(
            "'" + folder_.string() + "' cannot be made a folder" + (error ? ": " + error.message() : "") +
            "; expected a folder that can be written");
    }
}

void FrameFiles::wait() {
    if (!writing_.valid()) { return; }
    writing_.get();
}

void FrameFiles::add(int number, const View& view, double seconds, render::Image image) {
    wait();
    writing_ =
        std::async(std::launch::async, [path = folder_ / frame_name(number), picture = std::move(image)] {
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
    const std::string text = head.dump(1) + '\n';
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
    render::write_file_atomically(folder_ / "manifest.json", std::span(bytes, text.size()));
}

}  // namespace jw::host
