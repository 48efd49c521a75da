#include <cmath>
#include <optional>

#include "app/commands/options/dynamics_options.hpp"
#include "app/commands/options/shared_options.hpp"
#include "app/commands/program/add_command.hpp"
#include "app/session/output/export.hpp"
#include "app/session/output/json.hpp"
#include "app/session/story/dynamics_run.hpp"
#include "core/motion/tolerances.hpp"
#include "lessons/diagnostics/diagnostics.hpp"

namespace jw {

namespace {

struct SimulateOptions {
    std::string file;
    std::vector<std::string> experiments;
    std::optional<double> duration;
    std::optional<int> samples;
    std::optional<double> most_steps;
    DynamicsOptions dynamics;
    bool reactions = false;
    std::string format;
    std::vector<std::string> quantities;
    bool old_names = false;
};

DynamicsRequest request_for(const SimulateOptions& options, const Lesson& lesson) {
    DynamicsRequest request = request_of(lesson);
    apply(options.dynamics, request.settings);
    request.reactions = options.reactions;
    // options that fix the integrated coordinates, or the treatment of the constraints, also fix the kind of
    // method
    request.method_chosen = request.method_chosen || !options.dynamics.method.empty() ||
                            !options.dynamics.coordinates.empty() || drifts(request.settings.treatment);
    const bool adaptive = entry_of(request.settings.method).adaptive;
    if (adaptive) { request.settings.most_steps = kMostStepsUnasked; }
    if (options.most_steps) {
        if (!(*options.most_steps >= 1.0 && *options.most_steps <= 1e12)) {
            throw bad_option(
                "simulate", "--most-steps is " + short_number(*options.most_steps) + "; expected 1 to 1e12");
        }
        request.settings.most_steps = static_cast<long>(*options.most_steps);
    }
    request.duration = options.duration.value_or(request.duration);
    request.samples = options.samples.value_or(request.samples);
    if (!std::isfinite(request.duration) || request.duration <= 0.0) {
        throw bad_option(
            "simulate",
            "--duration is " + short_number(request.duration) + "; expected a time above 0, in s");
    }
    if (!entry_of(request.settings.method).adaptive &&
        request.duration / request.settings.step > kMostFixedSteps) {
        throw bad_option("simulate", "--step asks for more than ten million steps; expected a longer one");
    }
    if (request.samples < 1 || request.samples > 1'000'000) {
        throw bad_option(
            "simulate", "--samples is " + std::to_string(request.samples) + "; expected 1 to 1000000");
    }
    return request;
}

Exit simulate_command(const SimulateOptions& options, const Streams& streams) {
    const ChangedLesson changed = lesson_of(options.file, options.experiments, streams);
    const Lesson& lesson = changed.lesson;
    streams.err << done_text(changed.done);
    if (!lesson.dynamics) {
        throw CommandError(
            Exit::bad_input,
            options.file +
                ": error: this lesson has no [dynamics]; expected masses and a table [dynamics]\n"
                "hint: docs/writing-a-lesson.md, or 'jointwise solve' for its kinematics");
    }
    DynamicsRequest request = request_for(options, lesson);
    request.quantities = quantities_named("--quantities", options.quantities, lesson.mechanism, streams);
    DynamicsTable table;
    // notes are written during the simulation, as soon as they are known
    request.tell = [&](const std::string& note) {
        streams.err << (streams.err_is_terminal ? "\r\033[K" : "") << "jointwise: note: " << note << '\n'
                    << std::flush;
    };
    try {
        ProgressBar bar(streams, "simulating");
        request.progress = [&](double fraction) { bar.show(fraction); };
        table = simulate(lesson, request);
    } catch (const std::invalid_argument& error) {
        throw CommandError(Exit::bad_input, options.file + ": error: " + error.what());
    }
    if (options.old_names) { rename_columns(table.columns, table.column_of("p_drift")); }
    if (options.format == "json") {
        streams.out << document_of(json_of(table, lesson), changed.done);
    } else {
        streams.out << csv_of(table.columns, table.rows);
    }
    streams.err << "jointwise: " << table.summary << '\n';
    if (!table.fit_note.empty()) { streams.err << "jointwise: note: " << table.fit_note << '\n'; }
    if (!table.reaction_note.empty()) {
        streams.err << "jointwise: warning: " << table.reaction_note << '\n';
    }
    for (const std::string& name : table.not_unique) {
        streams.err << "jointwise: note: the reaction in '" << name
                    << "' is not unique, because equations are redundant; the smallest solution is shown\n";
    }
    if (table.failure.empty()) { return Exit::done; }
    streams.err << "jointwise: error: " << table.failure << '\n';
    return Exit::numerics;
}

}  // namespace

void add_simulate(const CommandLine& line) {
    auto [command, options] = add_command<SimulateOptions>(
        line, "simulate", "compute the motion under masses and forces, as a table", simulate_command,
        "Example: jointwise simulate lessons/catalogue/dynamics/andrews.toml --method explicit-8 --tolerance "
        "1e-9");
    add_lesson_options(command, options.file, options.experiments, "lesson file with [dynamics]");
    add_value(command, "--duration", options.duration, "T", "time to simulate [s]; default: the lesson's");
    add_value(
        command, "--samples", options.samples, "N", "number of equal intervals in the table; default: 100");
    add_dynamics_options(command, options.dynamics);
    add_value(
        command, "--most-steps", options.most_steps, "N",
        "steps after which an adaptive method gives up; default: one million");
    command.add_flag("--reactions", options.reactions, "also write forces and torques of all joints");
    add_format_option(command, options.format, {"csv", "json"});
    add_quantities_option(command, options.quantities);
    add_old_names_flag(command, options.old_names);
}

}  // namespace jw
