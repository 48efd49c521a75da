#include "app/session/output/json_tables.hpp"

namespace jw {

Json json_of(const Sweep& sweep, Analysis analysis, const Lesson& lesson) {
    Json rows = Json::array();
    for (const SweepRow& row : sweep.rows) {
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
        rows.push_back(std::move(entry));
    }
    return {
        {"format", "jointwise solve"},
        {"version", kJsonVersion},
        {"lesson", {{"file", lesson.file_name}, {"title", lesson.title}}},
        {"analysis", word_of(kAnalyses, analysis)},
        {"columns", sweep.columns},
        {"rows", rows},
        {"failure", sweep.failure.empty() ? Json() : Json(sweep.failure)}};
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
        {"pace_note", table.pace_note.empty() ? Json() : Json(table.pace_note)},
        {"reaction_residual", table.reaction_residual ? number(*table.reaction_residual) : Json()},
        {"reaction_bound", table.reaction_residual ? number(table.reaction_bound) : Json()},
        {"start_note", table.start_note.empty() ? Json() : Json(table.start_note)},
        {"fit_note", table.fit_note.empty() ? Json() : Json(table.fit_note)},
        {"failure", table.failure.empty() ? Json() : Json(table.failure)}};
}

}  // namespace jw
