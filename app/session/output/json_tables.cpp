#include "app/session/output/json.hpp"
#include "app/session/story/dynamics_run.hpp"
#include "app/session/view/solution.hpp"

namespace jw {

Json json_of(const Sweep& sweep, Analysis analysis, const Lesson& lesson) {
    const auto row_json = [&](const SweepRow& row) {
        Json entry{
            {"values", row.values},
            {"unique", row.unique},
            {"consistent", row.consistent},
            {"change_point", row.change_point},
            {"position_residual", json_of(row.residuals.position)}};
        if (analysis != Analysis::position) { entry["velocity_residual"] = json_of(row.residuals.velocity); }
        if (analysis == Analysis::acceleration) {
            entry["acceleration_residual"] = json_of(row.residuals.acceleration);
        }
        return entry;
    };
    return {
        {"format", "jointwise solve"},
        {"version", kJsonVersion},
        {"lesson", {{"file", lesson.file_name}, {"title", lesson.title}}},
        {"analysis", word_of(kAnalyses, analysis)},
        {"columns", sweep.columns},
        {"rows", list_of(sweep.rows, row_json)},
        {"failure", text_or_null(sweep.failure)}};
}

Json json_of(const DynamicsTable& table, const Lesson& lesson) {
    const IntegrationCounts& c = table.outcome.counts;
    return {
        {"format", "jointwise simulate"},
        {"version", kJsonVersion},
        {"lesson", {{"file", lesson.file_name}, {"title", lesson.title}}},
        {"columns", table.columns},
        {"rows", table.rows},
        {"counts",
         {{"steps", c.steps},
          {"rejected", c.rejected},
          {"evaluations", c.evaluations},
          {"projections", c.projections},
          {"jacobians", c.jacobians},
          {"row_choices", c.row_choices},
          {"singular_passages", c.singular_passages}}},
        {"residuals",
         {{"forces", table.outcome.residual.forces},
          {"constraint_accelerations", table.outcome.residual.constraints}}},
        {"not_unique", table.not_unique},
        {"pace_note", text_or_null(table.pace_note)},
        {"reaction_residual", table.reaction_residual ? number(*table.reaction_residual) : Json()},
        {"reaction_bound", table.reaction_residual ? number(table.reaction_bound) : Json()},
        {"start_note", text_or_null(table.start_note)},
        {"fit_note", text_or_null(table.fit_note)},
        {"failure", text_or_null(table.failure)}};
}

}  // namespace jw
