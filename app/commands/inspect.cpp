#include <CLI/CLI.hpp>

#include <cmath>
#include <optional>

#include "app/commands/options/experiment_option.hpp"
#include "app/commands/options/format_option.hpp"
#include "app/commands/program/commands.hpp"
#include "app/commands/program/outputs.hpp"
#include "app/commands/proof_file.hpp"
#include "app/session/output/describe_inspection.hpp"
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
        if (!std::isfinite(*options.time)) {
            throw CommandError(
                Exit::bad_input, "jointwise: error: --time is not finite; expected a time in s");
        }
        return inspect_time(lesson, *options.time, choice, spectrum);
    }
    StoryOptions how = options.step ? poses_only(true) : last_pose_only();
    how.last_step = options.step.value_or(-1);
    const Story story(lesson, how);
    const int last = static_cast<int>(story.steps().size()) - 1;
    if (!options.step) {
        if (const Step* failed = story.failure()) { throw not_reached(lesson, *failed); }
    }
    if (options.step && *options.step > last) {
        throw CommandError(
            Exit::bad_input, "jointwise: error: --step " + std::to_string(*options.step) +
                                 ": the lesson has steps 0 to " + std::to_string(last));
    }
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
        Json json = json_of(inspection, lesson);
        add_done(json, changed.done);
        streams.out << json_document(json);
    } else {
        streams.out << done_text(changed.done) << describe(inspection, lesson);
    }
    return Exit::done;
}

}  // namespace

void add_inspect(CLI::App& app, const Streams& streams, Run& run) {
    CLI::App* command = app.add_subcommand(
        "inspect", "show every number of the equations at one moment; default: the assembled pose");
    auto options = std::make_shared<InspectOptions>();
    command->add_option("FILE", options->file, "lesson file")->required()->type_name("");
    add_try_option(*command, options->experiments);
    auto* step =
        command->add_option("--step", options->step, "step of the lesson, as counted by 'jointwise step'")
            ->check(&fault_of_step)
            ->type_name("N");
    auto* time = command->add_option("--time", options->time, "time of the motion [s]")->type_name("T");
    auto* given =
        command->add_flag("--as-given", options->as_given, "use the state in the file, without assembly");
    step->excludes(time)->excludes(given);
    time->excludes(given);
    command->add_flag(
        "--spectrum", options->spectrum,
        "compute singular values and free motions also for more than 300 columns; this may take minutes, "
        "Ctrl-C stops it");
    command
        ->add_option(
            "--coordinates", options->coordinates,
            "rp, rp-modified, omega-local or omega-global; default: the lesson's")
        ->check(CLI::IsMember(words_of(kChoices)))
        ->type_name("CHOICE");
    add_format_option(*command, options->format, {"text", "json"});
    command->add_option("--proof", options->proof, "file for a proof of the rank (docs/proofs.md)")
        ->type_name("FILE");
    command->footer(
        "Example: jointwise inspect lessons/catalogue/loops/bennett.toml --coordinates omega-local --format "
        "json");
    command->callback(
        [options, &streams, &run] { run = [options, &streams] { return inspect(*options, streams); }; });
}

}  // namespace jw
