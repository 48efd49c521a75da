#include <CLI/CLI.hpp>

#include <cmath>
#include <optional>

#include "app/commands/commands.hpp"
#include "app/commands/experiment_option.hpp"
#include "app/commands/frame_range.hpp"
#include "app/commands/size_option.hpp"
#include "app/host/frames/frame_files.hpp"
#include "app/host/frames/frame_painter.hpp"
#include "app/panels/parts/characters.hpp"
#include "app/session/output/pace.hpp"

namespace jw {

namespace {

struct RenderOptions {
    std::string file;
    std::vector<std::string> experiments;
    std::string out;
    std::string size = "1280x720";
    double fps = 30.0;
    std::optional<std::string> frames;
    bool motion_only = false;
};

// below this the panels have no room; above it the letters do not fit into one texture
constexpr PixelSize kSmallestFrame{960, 540};
constexpr PixelSize kLargestFrame{3840, 2160};
constexpr double kMostFps = 240.0;
constexpr double kMostFrames = 100000.0;  // of the motion: an hour at 25 a second and more is a slip

int intervals_of(const Lesson& lesson, double fps) {
    if (!std::isfinite(fps)) {
        throw CommandError(Exit::bad_input, "jointwise: error: --fps is not finite; expected 0.1 to 240");
    }
    const std::optional<MotionPlan> motion = shown_motion(lesson);
    if (!motion) { return 0; }
    if (motion->duration * fps > kMostFrames) {
        throw CommandError(
            Exit::bad_input,
            "jointwise: error: 'duration_s' of the motion times --fps is more than 100000 "
            "pictures; shorten the one or lower the other");
    }
    return std::max(1, static_cast<int>(std::lround(motion->duration * fps)));
}

/// The frames to be drawn; empty (last before first) where only the motion is wanted and it is not reached.
FrameRange range_of(const RenderOptions& options, const Story& story) {
    const int frames = static_cast<int>(story.steps().size());
    if (options.frames) { return frame_range(*options.frames, frames); }
    if (!options.motion_only) { return {0, frames - 1}; }
    FrameRange motion{frames, frames - 1};
    for (int k = frames - 1; k >= 0; --k) {
        const Step::Kind kind = story.steps()[static_cast<std::size_t>(k)].kind;
        if (kind == Step::Kind::motion) { motion.first = k; }
        if (kind == Step::Kind::answer && motion.last == k) { motion.last = k - 1; }
    }
    if (motion.first > motion.last && story.failure() == nullptr) {
        throw CommandError(
            Exit::bad_input,
            "jointwise: error: --motion-only, but nothing moves in this lesson; expected "
            "a lesson with [motion] or [dynamics]");
    }
    return motion;
}

/// Draws the frames of `range` and writes them with their manifest.
void draw_frames(
    const RenderOptions& options, const PixelSize& size, const Story& story, const FrameRange& range,
    const std::vector<std::string>& done, const Streams& streams) {
    host::FrameFiles files(options.out, range.first, range.last, options.file);
    host::FramePainter painter(story, size.width, size.height);
    const std::string advice = panels::advice_for(panels::characters_of(story.lesson()));
    if (!advice.empty()) { streams.err << advice << '\n'; }
    ProgressBar bar(streams, "drawing");
    for (int k = range.first; k <= range.last; ++k) {
        const View view = view_of(story, k);
        files.add(k, view, seconds_to_look(view, 1.0 / options.fps), painter.paint(view));
        bar.show(static_cast<double>(k - range.first + 1) / (range.last - range.first + 1));
    }
    Json manifest{
        {"format", "jointwise render"},
        {"version", kJsonVersion},
        {"lesson", {{"file", story.lesson().file_name}, {"title", story.lesson().title}}},
        {"size", {size.width, size.height}},
        {"fps", options.fps},
        {"frames_in_all", story.steps().size()}};
    add_done(manifest, done);
    files.finish(manifest);
}

Exit render_command(const RenderOptions& options, const Streams& streams) {
    const PixelSize size = size_option(options.size, kSmallestFrame, kLargestFrame);
    const ChangedLesson changed = lesson_of(options.file, options.experiments, streams);
    const Lesson& lesson = changed.lesson;
    streams.err << done_text(changed.done);
    StoryOptions how;
    how.intervals = intervals_of(lesson, options.fps);
    const Story story(lesson, how);
    const FrameRange range = range_of(options, story);
    if (range.first > range.last) { throw not_reached(lesson, *story.failure()); }
    draw_frames(options, size, story, range, changed.done, streams);
    const int drawn = range.last - range.first + 1;
    streams.err << drawn << (drawn == 1 ? " picture" : " pictures") << " and manifest.json in " << options.out
                << '\n';
    if (const Step* failed = story.failure()) {
        streams.err << not_reached(lesson, *failed).what() << '\n';
        return Exit::numerics;
    }
    return Exit::done;
}

}  // namespace

void add_render(CLI::App& app, const Streams& streams, Run& run) {
    CLI::App* command =
        app.add_subcommand("render", "draw a lesson as PNG pictures, one per step and moment");
    auto options = std::make_shared<RenderOptions>();
    command->add_option("FILE", options->file, "lesson file")->required()->type_name("");
    add_try_option(*command, options->experiments);
    command->add_option("--out", options->out, "folder for the pictures and manifest.json; made if needed")
        ->required()
        ->type_name("DIR");
    command->add_option("--size", options->size, "pixels")->type_name("WxH")->capture_default_str();
    command->add_option("--fps", options->fps, "pictures per second of the motion")
        ->check(CLI::Range(0.1, kMostFps))
        ->type_name("X")
        ->capture_default_str();
    CLI::Option* frames =
        command->add_option("--frames", options->frames, "draw only frames A to B of the same numbering")
            ->type_name("A:B");
    command->add_flag("--motion-only", options->motion_only, "draw only the motion, by the same numbering")
        ->excludes(frames);
    command->footer(
        "Example: jointwise render lessons/catalogue/loops/four-bar.toml --out frames --size 1920x1080");
    command->callback([options, &streams, &run] {
        run = [options, &streams] { return render_command(*options, streams); };
    });
}

}  // namespace jw
