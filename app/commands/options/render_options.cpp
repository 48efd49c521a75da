#include "app/commands/options/render_options.hpp"

#include <CLI/CLI.hpp>

#include <charconv>
#include <cmath>

#include "app/commands/options/shared_options.hpp"
#include "app/commands/program/add_command.hpp"
#include "app/film/film_steps.hpp"

namespace jw {

namespace {

constexpr PixelSize kSmallestFrame{film::kSmallestWidth, film::kSmallestHeight};
constexpr PixelSize kSmallestPicture{film::kSmallestWidthAlone, film::kSmallestHeightAlone};
constexpr PixelSize kLargestFrame{film::kLargestWidth, film::kLargestHeight};
constexpr int kMostJobs = 256;

CommandError wrong(const std::string& message) { return bad_option("render", message); }

/// "1,-2,0.5" @throws CommandError
Vec3 direction_of(const std::string& text) {
    Vec3 v = Vec3::Zero();
    const char* at = text.data();
    const char* const end = at + text.size();
    bool is_good = true;
    for (int k = 0; k < 3 && is_good; ++k) {
        is_good = k == 0 || (at != end && *at++ == ',');
        const auto [stop, error] = std::from_chars(at, end, v[k]);
        is_good = is_good && error == std::errc() && std::isfinite(v[k]);
        at = stop;
    }
    if (is_good && at == end && film::is_direction(v)) { return v; }
    throw wrong(
        "--camera '" + text + "'; expected X,Y,Z, the direction in which the eye is, for example 1,-2,0.5");
}

void check_film(const RenderOptions& options, film::FilmFormat format) {
    check_output("--out", options.out, {options.file});
    if (film::needs_ffmpeg(format)) {
        check_output("--out", film::captions_file(options.out), {options.file});
    }
    const std::string problem = film::problem_of_format(options.settings());
    if (!problem.empty()) { throw wrong(problem); }
}

void check_range(const RenderOptions& options) {
    const int ranges = (options.frames ? 1 : 0) + (options.motion_only ? 1 : 0) +
                       (options.from.empty() && options.to.empty() ? 0 : 1);
    if (ranges > 1) { throw wrong("--frames, --motion-only and --from/--to exclude each other; give one"); }
    if (options.frames && options.format()) {
        throw wrong("--frames counts pictures of a folder; for a film give --from and --to");
    }
}

}  // namespace

host::FrameLook RenderOptions::look() const {
    return {dark ? render::Tone::dark : render::Tone::light, text, !no_panel, !transparent};
}

film::FilmSettings RenderOptions::settings() const {
    return {out, *format(), fps, loop ? render::Repeat::without_end : render::Repeat::once, !transparent};
}

CheckedRender checked(const RenderOptions& options) {
    CheckedRender result;
    result.size =
        size_option(options.size, options.no_panel ? kSmallestPicture : kSmallestFrame, kLargestFrame, true);
    if (!std::isfinite(options.fps)) { throw bad_input("--fps is not finite; expected 0.1 to 240"); }
    const std::string problem = film::problem_of_look(result.size.width, result.size.height, options.look());
    if (!problem.empty()) { throw wrong(problem); }
    if (!options.camera.empty()) { result.camera = direction_of(options.camera); }
    check_range(options);
    if (const auto format = options.format()) {
        check_film(options, *format);
    } else if (options.loop || options.no_tween) {
        throw wrong(
            "--loop and --no-tween apply only to films; expected --out with .gif, .apng, .mp4, .webm or "
            ".html");
    }
    if (!options.shard.empty() && !film::read_part(options.shard, result.shard)) {
        throw wrong("--shard '" + options.shard + "'; expected I/N, the I-th of N parts, for example 2/8");
    }
    if (!options.shard.empty() && options.resume) {
        throw wrong("--shard continues an interrupted part by itself; give --resume only after all parts");
    }
    return result;
}

void add_render_options(CLI::App& command, RenderOptions& options) {
    add_lesson_options(command, options.file, options.experiments);
    add_value(
        command, "--out", options.out, "PATH",
        "a film (.gif, .apng; .mp4, .webm with ffmpeg), a page (.html), or a folder for pictures, created if "
        "needed")
        ->required();
    add_value(command, "--size", options.size, "WxH", "size in pixels")->capture_default_str();
    add_value(command, "--fps", options.fps, "X", "pictures per second of motion")
        ->check(CLI::Range(0.1, film::kMostFps))
        ->capture_default_str();
    add_value(
        command, "--frames", options.frames, "A:B", "draw only pictures A to B; their numbers stay the same");
    command.add_flag("--motion-only", options.motion_only, "draw only the motion");
    add_value(
        command, "--from", options.from, "STEP", "begin at a step (from 1), a joint or driver, or t=TIME");
    add_value(command, "--to", options.to, "STEP", "end after this step");
    command.add_flag(
        "--no-tween", options.no_tween, "let bodies jump where an iteration or a joint moves them");
    command.add_flag("--loop", options.loop, "repeat a .gif or .apng without end");
    command.add_flag("--dark", options.dark, "light text on a dark background");
    add_value(command, "--text", options.text, "X", "size of text; 1 is normal")
        ->check(CLI::Range(0.75, 3.0))
        ->capture_default_str();
    add_value(
        command, "--camera", options.camera, "X,Y,Z",
        "look from this direction instead of that of the lesson");
    command.add_flag("--no-panel", options.no_panel, "draw only the mechanism and its names");
    command.add_flag("--transparent", options.transparent, "transparent background; with --no-panel");
    add_value(command, "--jobs", options.jobs, "N", "number of processes that draw; default: one per core")
        ->check(CLI::Range(1, kMostJobs));
    add_value(
        command, "--shard", options.shard, "I/N", "draw only the I-th of N parts, and leave it for --resume");
    command.add_flag(
        "--resume", options.resume, "continue with the pictures of an interrupted run or of --shard");
}

}  // namespace jw
