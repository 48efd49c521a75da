#include <CLI/CLI.hpp>

#include <cmath>
#include <optional>

#include "app/commands/options/shared_options.hpp"
#include "app/commands/program/add_command.hpp"
#include "app/session/output/export.hpp"
#include "app/session/output/json.hpp"
#include "app/session/view/solution.hpp"
#include "app/session/wording/numbers.hpp"
#include "lessons/lesson/enum_words.hpp"

namespace jw {

namespace {

struct SolveOptions {
    std::string file;
    std::vector<std::string> experiments;
    std::string analysis = "position";
    std::optional<double> from;
    std::optional<double> to;
    std::optional<double> step;
    std::string format;
    std::vector<std::string> quantities;
    bool old_names = false;
    std::string proof;
};

// more rows than this are probably caused by a misplaced decimal point
constexpr double kMostRows = 1e6;

SweepPlan plan_of(const SolveOptions& options, const Lesson& lesson) {
    const MotionPlan lesson_plan = lesson.motion.value_or(MotionPlan{});
    SweepPlan plan;
    plan.analysis = *value_of(kAnalyses, options.analysis);
    plan.from = options.from.value_or(lesson_plan.from);
    plan.to = options.to.value_or(std::max(lesson_plan.to, plan.from));
    plan.step = options.step.value_or((lesson_plan.to - lesson_plan.from) / lesson_plan.steps);
    if (!std::isfinite(plan.from) || !std::isfinite(plan.to) || !std::isfinite(plan.step)) {
        throw bad_option("solve", "--from, --to and --step must be finite numbers");
    }
    if (plan.to < plan.from) {
        throw bad_option("solve", "--to is before --from; expected a time at or after it");
    }
    if (plan.step <= 0.0) { throw bad_option("solve", "--step is not positive; expected a time in s"); }
    if ((plan.to - plan.from) / plan.step > kMostRows) {
        throw bad_option("solve", "--step is so small that there would be more than a million rows");
    }
    return plan;
}

void write_csv(const Sweep& sweep, std::ostream& out) {
    for (const std::string& column : sweep.columns) { out << csv_cell(column) << ','; }
    out << "unique,consistent,change_point\n";
    for (const SweepRow& row : sweep.rows) {
        for (const double value : row.values) { out << csv_number(value) << ','; }
        out << row.unique << ',' << row.consistent << ',' << row.change_point << '\n';
    }
}

/// Warns about the first row that violates its equations by more than rounding, if nothing else has said so.
void warn_of_residuals(const Sweep& sweep, Analysis analysis, const Streams& streams) {
    const auto say = [&](const char* what, EquationResidual KinematicResiduals::*part) {
        for (const SweepRow& row : sweep.rows) {
            const EquationResidual& found = row.residuals.*part;
            if (found.holds() || row.change_point || !row.consistent) { continue; }
            streams.err << "jointwise: warning: at t = " << number_text(row.values.front()) << " s " << what
                        << " violate their equations by " << small_text(found.residual)
                        << "; rounding explains only " << small_text(found.bound) << '\n';
            return;
        }
    };
    say("positions", &KinematicResiduals::position);
    if (analysis != Analysis::position) { say("velocities", &KinematicResiduals::velocity); }
    if (analysis == Analysis::acceleration) { say("accelerations", &KinematicResiduals::acceleration); }
}

void warn_of_crossings(const Sweep& sweep, const Streams& streams) {
    // after this many warnings about a motion of very many turns, their meaning is clear
    constexpr std::size_t most = 20;
    const std::size_t count = sweep.crossings.size();
    for (std::size_t k = 0; k < std::min(most, count); ++k) {
        streams.err << "jointwise: warning: at t = " << number_text(sweep.crossings[k], 6)
                    << " s the motion passes a change point, or comes very near one, and continues along its "
                       "tangent; it is not proved that it stays on its branch\n";
    }
    if (count > most) {
        streams.err << "jointwise: warning: the motion passes " << count - most << " more of them\n";
    }
}

void warn(const Sweep& sweep, Analysis analysis, const Lesson& lesson, const Streams& streams) {
    if (lesson.dynamics && !lesson.motion) {
        streams.err << "jointwise: note: masses and forces play no part here; 'jointwise simulate "
                    << lesson.file_name << "' moves it by them\n";
    }
    warn_of_crossings(sweep, streams);
    warn_of_residuals(sweep, analysis, streams);
    if (analysis == Analysis::position) { return; }
    const bool unique = std::ranges::all_of(sweep.rows, &SweepRow::unique);
    const bool consistent = std::ranges::all_of(sweep.rows, &SweepRow::consistent);
    if (!unique) {
        streams.err << "jointwise: note: not everything is driven; where 'unique' is 0 the velocities are "
                       "those nearest to the previous ones, the accelerations the smallest\n";
    }
    if (!consistent) {
        streams.err << "jointwise: warning: equations contradict each other where 'consistent' is 0"
                    << (sweep.contradiction.empty() ? "" : "; " + sweep.contradiction) << '\n';
    }
}

Exit solve_command(const SolveOptions& options, const Streams& streams) {
    if (!options.proof.empty()) { check_output("--proof", options.proof, {options.file}); }
    const ChangedLesson changed = lesson_of(options.file, options.experiments, streams);
    const Lesson& lesson = changed.lesson;
    streams.err << done_text(changed.done);
    SweepPlan plan = plan_of(options, lesson);
    plan.with_proof = !options.proof.empty();
    plan.quantities = quantities_named("--quantities", options.quantities, lesson.mechanism, streams);
    Sweep sweep;
    {
        ProgressBar bar(streams, "solving");
        sweep = solve_sweep(lesson, plan, [&](double fraction) { bar.show(fraction); });
    }
    if (sweep.proof) { write_proof(options.proof, *sweep.proof, *sweep.system, lesson); }
    if (options.old_names) { rename_columns(sweep.columns, sweep.columns.size() - plan.quantities.size()); }
    if (options.format == "json") {
        streams.out << document_of(json_of(sweep, plan.analysis, lesson), changed.done);
    } else {
        write_csv(sweep, streams.out);
    }
    warn(sweep, plan.analysis, lesson, streams);
    if (sweep.failure.empty()) { return Exit::done; }
    streams.err << sweep.failure << '\n';
    return Exit::numerics;
}

}  // namespace

void add_solve(const CommandLine& line) {
    auto [command, options] = add_command<SolveOptions>(
        line, "solve", "compute positions, velocities and accelerations over time, as a table", solve_command,
        "Example: jointwise solve lessons/catalogue/loops/four-bar.toml --analysis acceleration --from 0 "
        "--to 1 --step 0.1");
    add_lesson_options(command, options.file, options.experiments);
    add_value(command, "--analysis", options.analysis, "WHAT", "position, velocity or acceleration")
        ->check(CLI::IsMember(words_of(kAnalyses)));
    add_value(command, "--from", options.from, "T", "first time [s]; default: the lesson's");
    add_value(command, "--to", options.to, "T", "last time [s]; default: the lesson's");
    add_value(command, "--step", options.step, "T", "interval [s]; default: the lesson's");
    add_format_option(command, options.format, {"csv", "json"});
    add_quantities_option(command, options.quantities);
    add_old_names_flag(command, options.old_names);
    add_value(command, "--proof", options.proof, "FILE", "file for a proof of each step (docs/proofs.md)");
}

}  // namespace jw
