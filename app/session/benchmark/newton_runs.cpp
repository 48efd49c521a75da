#include "app/session/benchmark/newton_runs.hpp"

#include <algorithm>

#include "app/session/wording/explanations.hpp"
#include "app/session/wording/labels.hpp"
#include "app/session/wording/numbers.hpp"
#include "app/session/wording/text_table.hpp"

namespace jw {

namespace {

NewtonRun run_of(const NewtonTrace& trace, const std::string& name) {
    NewtonRun run;
    run.name = name;
    run.order = trace.order;
    run.converged = trace.converged;
    run.wrong_branch = trace.wrong_branch.has_value();
    for (const NewtonIterate& iterate : trace.iterates) {
        run.phi_norms.push_back(iterate.phi_norm);
        run.turns_deg.push_back(iterate.turn * kDegreesPerRadian);
    }
    return run;
}

std::string name_of_part(const Mechanism& m, const Addition& part) {
    const auto k = static_cast<std::size_t>(part.index);
    return part.kind == Addition::Kind::joint ? m.joints[k].name : m.drivers[k].name;
}

std::string title_of(const Story& story, int start, const NewtonPlan& plan) {
    const Step& step = story.steps()[static_cast<std::size_t>(start)];
    const std::string part = name_of_part(story.lesson().mechanism, *subject_of(story.lesson(), step));
    const std::string what = plan.by_method
                                 ? std::string("methods in ") + name_of_choice(plan.choice)
                                 : std::string("coordinates by ") + word_of(kNewtonMethods, plan.method);
    return "Closing " + part + " from the same start, " + what +
           (plan.normalisation_rows ? "" : ", without the rows pᵀp − 1");
}

std::string table_text(const NewtonComparison& comparison) {
    TextRows table{{"", "iterations", "‖Φ‖", "order", "turn"}};
    for (const NewtonRunRow& row : comparison.rows) {
        table.push_back(
            {row.name, std::to_string(row.iterations), small_text(row.phi_norm), row.order, row.turn,
             row.verdict});
    }
    return text_table(
        table, {{false, 22, 2}, {true, 10, 0}, {true, 10, 0}, {true, 8, 0}, {true, 10, 0}, {false, 0, 2}});
}

/// ‖Φ‖ before the first step and after each, one column per way.
std::string iterates_text(const NewtonRuns& runs) {
    TextRows table{{"‖Φ‖"}};
    table.front().insert(table.front().end(), runs.names.begin(), runs.names.end());
    std::size_t longest = 0;
    for (const NewtonTrace& trace : runs.traces) { longest = std::max(longest, trace.iterates.size()); }
    for (std::size_t k = 0; k < longest; ++k) {
        table.push_back({std::to_string(k)});
        for (const NewtonTrace& trace : runs.traces) {
            const bool goes_on = k < trace.iterates.size();
            table.back().push_back(goes_on ? small_text(trace.iterates[k].phi_norm) : "");
        }
    }
    std::vector<TextColumn> columns(runs.names.size() + 1, {true, 22, 0});
    columns.front() = {false, 5, 2};
    return text_table(table, columns);
}

Json json_of(const NewtonTrace& trace, const std::string& name, const std::string& wrong) {
    Json iterates = Json::array();
    for (const NewtonIterate& iterate : trace.iterates) {
        iterates.push_back(
            {{"phi_norm", number(iterate.phi_norm)},
             {"residual", number(iterate.residual)},
             {"delta_norm", number(iterate.delta_norm)},
             {"turn_rad", number(iterate.turn)},
             {"fraction", number(iterate.fraction)},
             {"damping", number(iterate.damping)}});
    }
    return {
        {"name", name},
        {"method", word_of(kNewtonMethods, trace.method)},
        {"converged", trace.converged},
        {"wrong_branch", wrong.empty() ? Json() : Json(wrong)},
        {"order", trace.order ? number(*trace.order) : Json()},
        {"iterates", iterates}};
}

}  // namespace

int start_of_telling_closing(const Story& story) {
    const auto iterates = [](const PositionEvent& event) {
        const auto* const newton = std::get_if<NewtonStep>(&event);
        return newton != nullptr && newton->rank > 0;  // otherwise the last check: closed, or given up
    };
    const auto is_branch = [](const PositionEvent& event) {
        return std::holds_alternative<WrongBranch>(event);
    };
    int start = -1;
    int telling = -1;
    std::pair<std::ptrdiff_t, std::ptrdiff_t> most{-1, -1};
    for (std::size_t k = 0; k < story.steps().size(); ++k) {
        const Step& step = story.steps()[k];
        if (step.kind == Step::Kind::equations) { start = static_cast<int>(k); }
        if (step.kind != Step::Kind::assembled && step.kind != Step::Kind::failed) { continue; }
        const std::pair found{
            std::ranges::count_if(step.events, is_branch), std::ranges::count_if(step.events, iterates)};
        if (found <= most) { continue; }
        most = found;
        telling = start;
    }
    return telling;
}

int start_of_closing(const Story& story, const Addition& subject) {
    for (std::size_t k = 0; k < story.steps().size(); ++k) {
        const Step& step = story.steps()[k];
        const bool starts = step.kind == Step::Kind::equations;
        if (starts && subject_of(story.lesson(), step) == subject) { return static_cast<int>(k); }
    }
    return -1;
}

std::size_t ways_of(const NewtonPlan& plan) {
    return plan.by_method ? kNewtonMethods.size() : kChoices.size();
}

bool run_next_way(const Story& story, int start, const NewtonPlan& plan, NewtonRuns& runs) {
    const std::size_t k = runs.traces.size();
    if (k == ways_of(plan)) { return false; }
    const Step& from = story.steps()[static_cast<std::size_t>(start)];
    const CoordinateChoice choice = plan.by_method ? plan.choice : kChoices[k].value;
    const NewtonMethod method = plan.by_method ? kNewtonMethods[k].value : plan.method;
    runs.title = title_of(story, start, plan);
    runs.names.push_back(plan.by_method ? word_of(kNewtonMethods, method) : name_of_choice(choice));
    runs.traces.push_back(with_choice(choice, [&](auto c) {
        return trace_newton<decltype(c)>(*from.system, from.state, from.t, method, plan.normalisation_rows);
    }));
    const std::optional<WrongBranch>& wrong = runs.traces.back().wrong_branch;
    runs.wrong_branches.push_back(wrong ? branch_text(*from.system, *wrong) : std::string());
    if (k + 1 < ways_of(plan)) { return true; }
    std::vector<NewtonRun> compared;
    for (std::size_t way = 0; way <= k; ++way) {
        compared.push_back(run_of(runs.traces[way], runs.names[way]));
    }
    runs.comparison = compare(compared);
    return true;
}

NewtonRuns run_newton(const Story& story, int start, const NewtonPlan& plan) {
    NewtonRuns runs;
    while (run_next_way(story, start, plan, runs)) {}
    return runs;
}

std::string describe(const NewtonRuns& runs) {
    std::string text = runs.title + "\n\n" + table_text(runs.comparison) + '\n' + iterates_text(runs) + '\n' +
                       runs.comparison.summary + '\n';
    for (std::size_t k = 0; k < runs.names.size(); ++k) {
        if (!runs.wrong_branches[k].empty()) { text += runs.names[k] + ": " + runs.wrong_branches[k] + '\n'; }
    }
    return text;
}

Json json_of(const NewtonRuns& runs, const Lesson& lesson) {
    Json all = Json::array();
    for (std::size_t k = 0; k < runs.names.size(); ++k) {
        all.push_back(json_of(runs.traces[k], runs.names[k], runs.wrong_branches[k]));
    }
    return {
        {"format", "jointwise newton"},
        {"version", kJsonVersion},
        {"lesson", {{"file", lesson.file_name}, {"title", lesson.title}}},
        {"title", runs.title},
        {"runs", all},
        {"summary", runs.comparison.summary}};
}

}  // namespace jw
