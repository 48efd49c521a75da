#include <CLI/CLI.hpp>

#include "app/commands/options/frame_range.hpp"
#include "app/commands/program/commands.hpp"
#include "app/commands/render_run.hpp"
#include "app/film/film_steps.hpp"

namespace jw {

namespace {

/// The moments of the motion; empty (last before first) if the motion is not reached.
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

/// The steps that are drawn; empty (last before first) if only the motion is wanted and it is not reached.
FrameRange range_of(const RenderOptions& options, const Story& story) {
    const int frames = static_cast<int>(story.steps().size());
    if (options.frames) { return frame_range(*options.frames, frames); }
    if (options.motion_only) { return motion_of(story); }
    const film::StepRange steps = film::steps_between(options.from, options.to, story);
    return {steps.first, steps.last};
}

Exit render_command(const RenderOptions& options, const Streams& streams) {
    const CheckedRender checked_options = checked(options);
    ChangedLesson changed = lesson_of(options.file, options.experiments, streams);
    if (checked_options.camera) {
        // only the direction of the eye is set; its distance and target are found again
        changed.lesson.camera.from = checked_options.camera;
    }
    const Lesson& lesson = changed.lesson;
    streams.err << done_text(changed.done);
    StoryOptions how;
    how.intervals = film::intervals_for(lesson, options.fps);
    const Story story(lesson, how);
    const FrameRange range = range_of(options, story);
    if (range.first > range.last) { throw not_reached(lesson, *story.failure()); }
    draw(options, checked_options, changed, story, range, streams);
    // a part reports nothing: the process that has started it tells the same story
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
