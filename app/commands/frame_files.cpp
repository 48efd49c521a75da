#include "app/commands/frame_files.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <span>

#include "app/commands/command.hpp"
#include "app/session/describe.hpp"
#include "render/png.hpp"

namespace jw {

namespace {

// of an attentive reader in a lecture, formulas beside the text
constexpr double kSecondsToLook = 1.5;
constexpr double kSecondsPerCharacter = 0.05;

CommandError bad_range(const std::string& text, int frames) {
    return CommandError(
        Exit::bad_input, "jointwise: error: --frames '" + text +
                             "'; expected A:B, A:, :B or A with numbers from 0 to " +
                             std::to_string(frames - 1) + ", the frames of this lesson");
}

std::optional<int> number_of(const std::string& text) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) { return std::nullopt; }
    return number;
}

}  // namespace

FrameRange frame_range(const std::string& text, int frames) {
    const std::size_t colon = text.find(':');
    const std::string from = text.substr(0, colon);
    const std::string to = colon == std::string::npos ? from : text.substr(colon + 1);
    if (from.empty() && to.empty()) { throw bad_range(text, frames); }
    const std::optional<int> first = from.empty() ? 0 : number_of(from);
    const std::optional<int> last = to.empty() ? frames - 1 : number_of(to);
    if (!first || !last || *first < 0 || *last < *first || *last >= frames) { throw bad_range(text, frames); }
    return {*first, *last};
}

std::string frame_name(int number) {
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "frame_%05d.png", number);
    return name.data();
}

double seconds_of(const View& view, double fps) {
    if (view.kind == Step::Kind::motion) { return 1.0 / fps; }
    if (view.kind == Step::Kind::iteration) { return kSecondsToLook; }
    const int characters = displayed_width(view.sentence) + displayed_width(view.author_text);
    return kSecondsToLook + kSecondsPerCharacter * characters;
}

FrameFiles::FrameFiles(std::filesystem::path folder) : folder_(std::move(folder)) {
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    if (error || !std::filesystem::is_directory(folder_)) {
        throw CommandError(
            Exit::bad_input, "jointwise: error: --out '" + folder_.string() + "' cannot be made a folder" +
                                 (error ? ": " + error.message() : "") +
                                 "; expected a folder that can be written");
    }
}

void FrameFiles::wait() {
    if (!writing_.valid()) { return; }
    try {
        writing_.get();
    } catch (const std::exception& error) {
        throw CommandError(Exit::bad_input, std::string("jointwise: error: ") + error.what());
    }
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
    try {
        const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
        render::write_file_atomically(folder_ / "manifest.json", std::span(bytes, text.size()));
    } catch (const std::exception& error) {
        throw CommandError(Exit::bad_input, std::string("jointwise: error: ") + error.what());
    }
}

}  // namespace jw
