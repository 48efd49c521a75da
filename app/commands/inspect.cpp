#include <CLI/CLI.hpp>

#include <cmath>
#include <optional>

#include "app/commands/options/shared_options.hpp"
#include "app/commands/program/add_command.hpp"
#include "app/session/output/describe.hpp"
#include "app/session/output/json.hpp"
#include "app/session/wording/labels.hpp"
#include "lessons/lesson/enum_words.hpp"

namespace jw {

namespace {

struct InspectOptions {
    std::string file;
    std::vector<std::string> experiments;
    std::optional<int> step;
    std::optional<double> time;
    bool as_given = false;
    bool spectrum = false;
    std::string coordinates;
    std::string format;
    std::string proof;
};

Inspection inspected(const InspectOptions& options, const Lesson& lesson) {
    const CoordinateChoice choice = value_of(kChoices, options.coordinates).value_or(lesson.coordinates);
    const Spectrum spectrum = options.spectrum ? Spectrum::always : Spectrum::of_small;
    if (options.as_given) { return inspect_as_given(lesson, choice, spectrum); }
    if (options.time) {
        if (!std::isfinite(*options.time)) { throw bad_input("--time is not finite; expected a time in s"); }
        return inspect_time(lesson, *options.time, choice, spectrum);
    }
    StoryOptions how = options.step ? poses_only(true) : last_pose_only();
    how.last_step = options.step.value_or(-1);
    const Story story(lesson, how);
    const int last = static_cast<int>(story.steps().size()) - 1;
    if (!options.step) {
        if (const Step* failed = story.failure()) { throw not_reached(lesson, *failed); }
    }
    if (options.step) { check_step("--step", *options.step, last); }
    return inspect_step(story, options.step.value_or(last), choice, spectrum);
}

/// Writes a proof of the rank at the inspected moment, as the start of a motion without steps.
void write_rank(const std::string& file, const Inspection& inspection, const Lesson& lesson) {
    ProofRecorder recorder(*inspection.system);
    MotionFrame frame;
    frame.t = inspection.t;
    frame.state = inspection.state;
    frame.velocity = inspection.velocity;
    recorder.add(frame);
    write_proof(file, recorder.take(), *inspection.system, lesson);
}

Exit inspect(const InspectOptions& options, const Streams& streams) {
    if (!options.proof.empty()) { check_output("--proof", options.proof, {options.file}); }
    const ChangedLesson changed = lesson_of(options.file, options.experiments, streams);
    const Lesson& lesson = changed.lesson;
    const Inspection inspection = inspected(options, lesson);
    if (!options.proof.empty()) { write_rank(options.proof, inspection, lesson); }
    if (options.format == "json") {
        streams.out << document_of(json_of(inspection, lesson), changed.done);
    } else {
        streams.out << done_text(changed.done) << describe(inspection, lesson);
    }
    return Exit::done;
}

}  // namespace

void add_inspect(const CommandLine& line) {
    auto [command, options] = add_command<InspectOptions>(
        line, "inspect", "show every number of the equations at one moment; default: the assembled pose",
        inspect,
        "Example: jointwise inspect lessons/catalogue/loops/bennett.toml --coordinates omega-local --format "
        "json");
    add_lesson_options(command, options.file, options.experiments);
    auto* step =
        add_value(command, "--step", options.step, "N", "step of the lesson, as counted by 'jointwise step'")
            ->check(&fault_of_step);
    auto* time = add_value(command, "--time", options.time, "T", "time of the motion [s]");
    auto* given =
        command.add_flag("--as-given", options.as_given, "use the state in the file, without assembly");
    step->excludes(time)->excludes(given);
    time->excludes(given);
    command.add_flag(
        "--spectrum", options.spectrum,
        "compute singular values and free motions also for more than 300 columns; this may take minutes, "
        "Ctrl-C stops it");
    add_value(
        command, "--coordinates", options.coordinates, "CHOICE",
        "rp, rp-modified, omega-local or omega-global; default: the lesson's")
        ->check(CLI::IsMember(words_of(kChoices)));
    add_format_option(command, options.format, {"text", "json"});
    add_value(command, "--proof", options.proof, "FILE", "file for a proof of the rank (docs/proofs.md)");
}

}  // namespace jw
