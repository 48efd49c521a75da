#include <CLI/CLI.hpp>

#include <algorithm>

#include "app/commands/options/shared_options.hpp"
#include "app/commands/program/add_command.hpp"
#include "app/session/benchmark/newton_runs.hpp"
#include "lessons/diagnostics/diagnostics.hpp"
#include "lessons/lesson/enum_words.hpp"

namespace jw {

namespace {

struct NewtonChoices {
    std::string file;
    std::vector<std::string> experiments;
    std::string at;
    std::string compare = "methods";
    std::string coordinates;
    std::string method = "limited";
    bool without_normalisation = false;
    std::string format;
};

NewtonPlan plan_of(const NewtonChoices& options, const Lesson& lesson) {
    NewtonPlan plan;
    plan.by_method = options.compare == "methods";
    plan.choice = options.coordinates.empty() ? lesson.coordinates : *value_of(kChoices, options.coordinates);
    plan.method = *value_of(kNewtonMethods, options.method);
    plan.normalisation_rows = !options.without_normalisation;
    return plan;
}

/// The step at which closing the joint or driver `at` begins. Without a name, the closing that shows most
/// about Newton's method: one with a wrong branch, or with the most iterations.
int start_of(const Story& story, const std::string& at) {
    const Lesson& lesson = story.lesson();
    std::vector<std::string> names;
    for (const Addition& addition : lesson.order) {
        const auto k = static_cast<std::size_t>(addition.index);
        const bool is_joint = addition.kind == Addition::Kind::joint;
        names.push_back(is_joint ? lesson.mechanism.joints[k].name : lesson.mechanism.drivers[k].name);
    }
    if (names.empty()) { throw bad_input("the lesson has no joint: nothing is solved"); }
    if (at.empty()) { return start_of_telling_closing(story); }
    const std::size_t place = place_in(names, at, "--at " + in_quotes(at) + ": no such joint or driver");
    const int start = start_of_closing(story, lesson.order[place]);
    if (start < 0) { throw not_reached(lesson, *story.failure()); }
    return start;
}

Exit newton(const NewtonChoices& options, const Streams& streams) {
    const ChangedLesson changed = lesson_of(options.file, options.experiments, streams);
    const Story story(changed.lesson, poses_only());
    const NewtonRuns runs = run_newton(story, start_of(story, options.at), plan_of(options, changed.lesson));
    if (options.format == "json") {
        streams.out << document_of(json_of(runs, changed.lesson), changed.done);
    } else if (options.format == "csv") {
        streams.err << done_text(changed.done);
        streams.out << csv_of(runs.comparison.residuals);
    } else {
        streams.out << changed.lesson.title << '\n' << done_text(changed.done) << describe(runs);
    }
    const bool any = std::ranges::any_of(runs.traces, &NewtonTrace::converged);
    if (!any) { streams.err << changed.lesson.file_name << ": " << runs.comparison.summary << '\n'; }
    return any ? Exit::done : Exit::numerics;
}

}  // namespace

void add_newton(const CommandLine& line) {
    auto [command, options] = add_command<NewtonChoices>(
        line, "newton", "compare variants of Newton's method, or coordinates, from one start", newton,
        "Example: jointwise newton lessons/catalogue/hard/anti-parallel.toml --compare methods");
    add_lesson_options(command, options.file, options.experiments);
    add_value(
        command, "--at", options.at, "NAME",
        "joint or driver to close; default: one that meets a wrong branch, else the one with most "
        "iterations");
    add_value(command, "--compare", options.compare, "WHAT", "what to compare: methods or coordinates")
        ->check(CLI::IsMember({"methods", "coordinates"}))
        ->capture_default_str();
    add_value(
        command, "--coordinates", options.coordinates, "CHOICE",
        "coordinates of the methods; default: the lesson's")
        ->check(CLI::IsMember(words_of(kChoices)));
    add_value(command, "--method", options.method, "METHOD", "method used to compare coordinates")
        ->check(CLI::IsMember(words_of(kNewtonMethods)))
        ->capture_default_str();
    command.add_flag(
        "--without-normalisation", options.without_normalisation, "leave out the rows p'p - 1 in (r, p)");
    add_format_option(command, options.format, {"text", "json", "csv"});
}

}  // namespace jw
