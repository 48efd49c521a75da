#include <algorithm>
#include <array>

#include "app/session/output/describe.hpp"
#include "app/session/try/possible_experiments.hpp"
#include "app/session/wording/explanations.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "app/session/wording/text_table.hpp"
#include "app/session/wording/text_width.hpp"

namespace jw {

namespace {

constexpr int kWidth = 100;
constexpr int kVerdictWidth = 21;

std::string summary_of(const Effect& e) {
    return tr(
        "{0}, rank {1}, {2}, {3} redundant, condition {4}", tr_count(e.rows, "{0} equation", "{0} equations"),
        e.rank, tr_count(e.dof, "{0} freedom", "{0} freedoms"), e.redundant(), number_text(e.condition, 3));
}

/// Columns that are the same for all groups: as wide as the widest text of any group.
std::vector<TextColumn> columns_for(int widest) {
    const TextColumn number{true, 10, 0};
    return {{false, widest, 2}, number, number, number, number, {false, 0, 2}};
}

std::vector<std::string> cells(const PossibleExperiment& e) {
    // geometry has no effect yet: it is listed as it is
    if (!e.effect) { return {e.text, e.now ? tr("as it is") : ""}; }
    const std::string note = e.now ? tr("as it is") : "";
    const std::string price = e.free ? tr("keeps the rank") : "";
    return {
        e.text,
        std::to_string(e.effect->rank),
        std::to_string(e.effect->dof),
        std::to_string(e.effect->redundant()),
        number_text(e.effect->condition, 3),
        note + (note.empty() || price.empty() ? "" : "  ") + price};
}

int widest_of(const ExperimentGroup& group) {
    int widest = 0;
    for (const PossibleExperiment& e : group.experiments) {
        widest = std::max(widest, displayed_width(e.text));
    }
    return widest;
}

std::string motions_text(const PossibleExperiments& all) {
    if (all.free_motions.empty()) {
        return std::string(tr("No free motion: every direction is constrained.")) + '\n';
    }
    std::string text = std::string(tr("Free motions")) + '\n';
    for (const FreeMotionVerdict& v : all.free_motions) {
        const std::string motion = v.leaves.empty() ? v.motion : v.motion + "; " + v.leaves;
        text += "  " + padded(v.text, 12) + padded(verdict_text(v.verdict), kVerdictWidth) +
                wrapped(motion, kWidth - 14 - kVerdictWidth, 14 + kVerdictWidth) + '\n';
    }
    return text;
}

std::string repeated_text(const PossibleExperiments& all) {
    if (all.combinations.empty()) { return std::string(tr("No equation is redundant.")) + "\n\n"; }
    std::string text = std::string(tr("Redundant equations")) + '\n';
    for (const std::string& combination : all.combinations) {
        text += "  " + wrapped(combination, kWidth - 2, 4) + '\n';
    }
    const std::string list = joined(all.removable, ", ");
    const std::string verdict = all.present.redundant() == 1
                                    ? tr("Taking out any one of these restores full row rank: {0}", list)
                                    : tr("Taking out any one of these leaves the rank as it is: {0}", list);
    return text + "  " + wrapped(verdict, kWidth - 2, 4) + "\n\n";
}

Json json_of(const Effect& e) {
    return {
        {"rows", e.rows},
        {"rank", e.rank},
        {"dof", e.dof},
        {"redundant", e.redundant()},
        {"condition", number(e.condition)}};
}

Json json_of(const ExperimentGroup& group) {
    const auto experiment_json = [](const PossibleExperiment& e) -> Json {
        return {
            {"try", e.text},
            {"now", e.now},
            {"costs_no_rank", e.free},
            {"effect", e.effect ? json_of(*e.effect) : Json()}};
    };
    return {{"title", group.title}, {"experiments", list_of(group.experiments, experiment_json)}};
}

}  // namespace

ExperimentsText::ExperimentsText(const PossibleExperiments& outline, const Lesson& lesson)
    : widest_(widest_of(outline.coordinates)) {
    for (const ExperimentGroup& group : outline.groups) { widest_ = std::max(widest_, widest_of(group)); }
    head_ = lesson.title + '\n' +
            tr("{0} (step {1}): {2}", outline.moment, outline.step, summary_of(outline.present)) + "\n\n" +
            text_table(
                {{"", tr("rank"), tr("freedoms"), tr("redundant"), tr("condition")}}, columns_for(widest_));
}

std::string ExperimentsText::group(const ExperimentGroup& group) const {
    TextRows rows;
    for (const PossibleExperiment& e : group.experiments) { rows.push_back(cells(e)); }
    return group.title + '\n' + text_table(rows, columns_for(widest_)) + '\n';
}

std::string ExperimentsText::rest(const PossibleExperiments& all) const {
    return group(all.coordinates) + repeated_text(all) + motions_text(all);
}

std::string describe(const PossibleExperiments& all, const Lesson& lesson) {
    const ExperimentsText pieces(all, lesson);
    std::string text = pieces.head();
    for (const ExperimentGroup& group : all.groups) { text += pieces.group(group); }
    return text + pieces.rest(all);
}

Json json_of(const PossibleExperiments& all, const Lesson& lesson) {
    Json motions = Json::array();
    for (const FreeMotionVerdict& v : all.free_motions) {
        motions.push_back({{"try", v.text}, {"motion", v.motion}, {"finite", v.is_finite()}});
        motions.back().update(json_of(static_cast<const FreedomJudgement&>(v), lesson.mechanism));
    }
    return {
        {"format", "jointwise try"},
        {"version", kJsonVersion},
        {"lesson", {{"file", lesson.file_name}, {"title", lesson.title}}},
        {"moment", all.moment},
        {"step", all.step},
        {"present", json_of(all.present)},
        {"groups", list_of(all.groups, [](const ExperimentGroup& group) { return json_of(group); })},
        {"coordinates", json_of(all.coordinates)},
        {"combinations", all.combinations},
        {"removable", all.removable},
        {"free_motions", motions}};
}

}  // namespace jw
