#include <CLI/CLI.hpp>

#include <cmath>

#include "app/commands/commands.hpp"
#include "app/commands/frame_range.hpp"
#include "app/commands/render_run.hpp"
#include "app/session/story/timeline.hpp"

namespace jw {

namespace {

constexpr double kMostFrames = 100000.0;  // of the motion: an hour at 25 a second and more is a slip

int intervals_of(const Lesson& lesson, double fps) {
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

/// The moments; empty (last before first) where the motion is not reached.
FrameRange motion_of(const Story& story) {
    const int frames = static_cast<int>(story.steps().size());
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

int step_named(const std::string& option, const std::string& name, const Story& story) {
    if (const std::optional<int> step = step_at(story, name)) { return *step; }
    throw CommandError(
        Exit::bad_input, "jointwise: error: " + option + " '" + name + "'; expected a step from 1 to " +
                             std::to_string(story.steps().size()) +
                             ", the name of a joint or driver, or t=SECONDS");
}

/// The steps that are drawn; empty (last before first) where only the motion is wanted and it is not reached.
FrameRange range_of(const RenderOptions& options, const Story& story) {
    const int frames = static_cast<int>(story.steps().size());
    if (options.frames) { return frame_range(*options.frames, frames); }
    if (options.motion_only) { return motion_of(story); }
    FrameRange range{0, frames - 1};
    if (!options.from.empty()) { range.first = step_named("--from", options.from, story); }
    if (!options.to.empty()) { range.last = step_named("--to", options.to, story); }
    if (range.first <= range.last) { return range; }
    throw CommandError(
        Exit::bad_input, "jointwise: error: --to '" + options.to + "' is step " +
                             std::to_string(range.last + 1) + ", before step " +
                             std::to_string(range.first + 1) + " of --from");
}

Exit render_command(const RenderOptions& options, const Streams& streams) {
    const CheckedRender checked_options = checked(options);
    ChangedLesson changed = lesson_of(options.file, options.experiments, streams);
    if (checked_options.camera) {
        // the eye goes there; how far, and at what it looks, is found anew
        changed.lesson.camera.from = checked_options.camera;
    }
    const Lesson& lesson = changed.lesson;
    streams.err << done_text(changed.done);
    StoryOptions how;
    how.intervals = intervals_of(lesson, options.fps);
    const Story story(lesson, how);
    const FrameRange range = range_of(options, story);
    if (range.first > range.last) { throw not_reached(lesson, *story.failure()); }
    draw(options, checked_options, changed, story, range, streams);
    // a part has no say: who has started it tells the same story
    const Step* const failed = film::part_of_environment() ? nullptr : story.failure();
    if (failed == nullptr) { return Exit::done; }
    streams.err << not_reached(lesson, *failed).what() << '\n';
    return Exit::numerics;
}

}  // namespace

void add_render(CLI::App& app, const Streams& streams, Run& run) {
    CLI::App* command = app.add_subcommand("render", "draw a lesson as a film, or as PNG pictures");
    auto options = std::make_shared<RenderOptions>();
    add_render_options(*command, *options);
    command->footer(
        "Example: jointwise render lessons/catalogue/loops/four-bar.toml --out four-bar.mp4 --size "
        "1920x1080");
    command->callback([options, &streams, &run] {
        run = [options, &streams] { return render_command(*options, streams); };
    });
}

}  // namespace jw
