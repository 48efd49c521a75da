#include "app/host/tabs/experiment_tab.hpp"

#include <algorithm>

#include <imgui.h>

#include "app/host/ui/widgets.hpp"
#include "app/panels/parts/text_lines.hpp"
#include "app/session/wording/explanations.hpp"
#include "app/session/wording/labels.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "lessons/math/text_parts.hpp"

namespace jw::host {

namespace {

/// Summary of the last Newton solve: "Newton: 4 iterations, the last ‖Φ‖ 1e-16".
std::string newton_text(const Session& session) {
    const std::vector<NewtonRow>& rows = session.view().newton;
    if (rows.empty()) { return {}; }
    const auto steps = static_cast<int>(std::ranges::count(rows, true, &NewtonRow::stepped));
    const std::string last = number_text(rows.back().phi_norm, 2);
    return session.view().failure.empty()
               ? tr_count(
                     steps, "Newton: {0} iteration, the last ‖Φ‖ = {1}",
                     "Newton: {0} iterations, the last ‖Φ‖ = {1}", last)
               : tr_count(
                     steps, "Newton: {0} iteration, not closed, the last ‖Φ‖ = {1}",
                     "Newton: {0} iterations, not closed, the last ‖Φ‖ = {1}", last);
}

/// Shows the result of all experiments so far, in one line that is always there.
void verdict(const LessonUi& ui) {
    const RankView& rank = ui.session.view().rank;
    std::string text = tr_count(
        rank.dof, "{1} equations, rank {2}, {0} freedom", "{1} equations, rank {2}, {0} freedoms", rank.rows,
        rank.rank);
    if (rank.differs_once_assembled()) {
        text = tr("{0}, rank {1} once assembled", text, *rank.once_assembled);
    }
    if (rank.redundant() > 0) { text = tr("{0}, {1} redundant", text, rank.redundant()); }
    ImGui::PushFont(ui.canvas.fonts().bold);
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
    const std::vector<double>& sigma = rank.singular_values;
    if (rank.rank > 0 && static_cast<std::size_t>(rank.rank) <= sigma.size()) {
        const double smallest = sigma[static_cast<std::size_t>(rank.rank) - 1];
        note(
            ui, tr("smallest singular value {0}, condition {1}", number_text(smallest, 3),
                   number_text(sigma.front() / smallest, 3)));
    }
    note(ui, newton_text(ui.session));
}

void history(const LessonUi& ui) {
    const std::string undo = ui.session.undo_text();
    const std::string redo = ui.session.redo_text();
    const auto button = [&](Command command, const char* label, bool possible) {
        ImGui::BeginDisabled(!possible);
        command_button(ui, command, label);
        ImGui::EndDisabled();
    };
    button(Command::undo, tr("Undo"), !undo.empty());
    ImGui::SameLine();
    button(Command::redo, tr("Redo"), !redo.empty());
    beside_if_it_fits(tr("Reset"), 1.0F);
    button(Command::start_over, tr("Reset"), ui.session.is_changed());
    // shown from the start, so that nothing below it moves
    note(ui, undo.empty() ? tr("no change yet") : tr("last change: {0}", undo));
}

void coordinates(const LessonUi& ui) {
    section(ui, tr("Coordinates of Φq"));
    CoordinateChoice choice = ui.session.lesson().coordinates;
    if (choose("##coordinates", -1.0F, kChoices, choice)) { ui.requests.add(SetCoordinates{choice}); }
}

/// For each joint and driver: a check box to take it out, and its name to select it.
void parts(const LessonUi& ui) {
    section(ui, tr("Joints and drivers"));
    const Lesson& lesson = ui.session.lesson();
    const Lesson& written = ui.session.as_written();
    for (const Addition& addition : written.order) {
        const auto k = static_cast<std::size_t>(addition.index);
        const bool is_joint = addition.kind == Addition::Kind::joint;
        const std::string& name =
            is_joint ? lesson.mechanism.joints[k].name : lesson.mechanism.drivers[k].name;
        bool present = std::ranges::find(lesson.order, addition) != lesson.order.end();
        ImGui::PushID(is_joint ? "joint" : "driver");
        ImGui::PushID(addition.index);
        if (ImGui::Checkbox("##present", &present)) { ui.requests.add(SetPresent{addition, present}); }
        tip_of_item(present ? tr("take it out") : tr("put it back"));
        ImGui::SameLine();
        const std::string type = is_joint ? std::string(lesson.mechanism.joints[k].type->name) : tr("driver");
        const bool chosen = is_joint && experiment_joint_of(ui) == addition.index;
        if (ImGui::Selectable((name + "   " + type).c_str(), chosen) && is_joint) {
            ui.state.experiment_joint = addition.index;
        }
        ImGui::PopID();
        ImGui::PopID();
    }
}

/// Redundant equations, and the equations of which any single one can be taken out without loss of rank.
void repeated_equations(const LessonUi& ui) {
    const RankReport& report = ui.session.rank();
    if (report.redundant_rows.empty()) { return; }
    const System& system = *ui.session.step().system;
    section(ui, tr("Redundant equations"));
    const std::vector<std::string>& combinations = ui.session.view().rank.combinations;
    for (std::size_t k = 0; k < combinations.size(); ++k) {
        note(ui, combinations[k]);
        if (!ImGui::IsItemHovered()) { continue; }
        // the redundant equation and those that imply it
        const RedundantRow& repeated = report.redundant_rows[k];
        ui.requests.lit_rows.push_back(repeated.row);
        for (const RedundantRow::Term& term : repeated.terms) { ui.requests.lit_rows.push_back(term.row); }
    }
    note(
        ui, report.redundant() == 1 ? tr("Taking out any one of these restores full row rank:")
                                    : tr("Taking out any one of these leaves the rank as it is:"));
    for (const int row : removable_rows(report)) {
        ImGui::PushID(row);
        const RowOrigin origin = system.origin(row);
        if (origin.kind == RowOrigin::Kind::constraint) {
            const Constraint& c = system.constraints()[static_cast<std::size_t>(origin.index)];
            if (small_button(tr("take out"))) {
                ui.requests.add(SetEquationPresent{c.joint, {c.role, origin.component}, false});
            }
            ImGui::SameLine();
        }
        ImGui::TextUnformatted(row_label(system, row).c_str());
        if (ImGui::IsItemHovered()) { ui.requests.lit_rows.push_back(row); }
        ImGui::PopID();
    }
}

std::string followed_text(const System& system, const FreedomJudgement& followed) {
    switch (followed.verdict) {
        case FreedomVerdict::finite: return tr("The motion is finite.");
        case FreedomVerdict::cannot_tell: return tr("It is not known whether the motion is finite.");
        case FreedomVerdict::first_order: break;
    }
    const std::string leaves = departure_text(system, *followed.departure);
    return followed.has_motion_beside
               ? tr("To first order only: the motion {0}. A nearby finite motion is shown.", leaves)
               : tr("To first order only: the motion {0}.", leaves);
}

/// Text of a free motion, with its verdict at the steps that list free motions.
std::string told_freedom(const LessonUi& ui, int motion) {
    const MotionsWhenAsked& judged = ui.session.view().rank.judged_motions;
    if (judged) {
        const auto listed = std::ranges::find(*judged, motion, &ListedMotion::index);
        if (listed != judged->end()) { return listed->told; }
    }
    const FreeMotion& direction = ui.session.rank().free_motions[static_cast<std::size_t>(motion)];
    return free_motion_text(*ui.session.step().system, direction);
}

void freedoms(const LessonUi& ui) {
    const RankReport& report = ui.session.rank();
    section(ui, tr("Freedoms"));
    if (report.free_motions.empty()) {
        return note(ui, tr("Nothing can move: every direction is constrained."));
    }
    const System& system = *ui.session.step().system;
    for (std::size_t k = 0; k < report.free_motions.size(); ++k) {
        ImGui::PushID(static_cast<int>(k));
        const bool plays = ui.state.playback.freedom() == static_cast<int>(k);
        if (toggle_button(ui, plays ? tr("Stop") : tr("Move"), plays, ui.px(52.0F))) {
            if (plays) {
                ui.requests.add(Command::let_go);
            } else {
                ui.state.playback.follow(static_cast<int>(k));
            }
        }
        ImGui::SameLine();
        note(ui, told_freedom(ui, static_cast<int>(k)));
        if (plays) {
            if (const FollowedMotion* shown = ui.session.shown_freedom()) {
                note(ui, followed_text(system, *shown));
            }
        }
        ImGui::PopID();
    }
}

/// Experiments that the author proposes.
void trials(const LessonUi& ui) {
    const std::vector<Trial>& proposed = ui.session.lesson().trials;
    if (proposed.empty()) { return; }
    section(ui, tr("Proposed"));
    for (std::size_t k = 0; k < proposed.size(); ++k) {
        ImGui::PushID(static_cast<int>(k));
        if (small_button(proposed[k].breaks ? tr("Break") : tr("Try"))) {
            ui.requests.trial = static_cast<int>(k);
        }
        std::string tip;
        for (const std::string& action : proposed[k].actions) { tip += (tip.empty() ? "" : "\n") + action; }
        tip_of_item(tip);
        ImGui::SameLine();
        note(ui, math::plain_words(proposed[k].text));
        ImGui::PopID();
    }
}

}  // namespace

int experiment_joint_of(const LessonUi& ui) {
    const auto count = static_cast<int>(ui.session.lesson().mechanism.joints.size());
    if (ui.state.experiment_joint >= 0 && ui.state.experiment_joint < count) {
        return ui.state.experiment_joint;
    }
    if (const auto subject = subject_of(ui.session.lesson(), ui.session.step())) {
        if (subject->kind == Addition::Kind::joint) { return subject->index; }
        const int driven =
            ui.session.lesson().mechanism.drivers[static_cast<std::size_t>(subject->index)].joint;
        if (driven >= 0) { return driven; }
    }
    const std::vector<int> featured = featured_joints(ui.session.story());
    if (!featured.empty()) { return featured.front(); }
    return count > 0 ? 0 : -1;
}

void experiment_tab(const LessonUi& ui, const panels::Box& box) {
    Area area(ui, "try", box, true);
    verdict(ui);
    history(ui);
    trials(ui);
    if (const int joint = experiment_joint_of(ui); joint >= 0) { experiment_joint(ui, joint); }
    repeated_equations(ui);
    freedoms(ui);
    parts(ui);
    experiment_drivers(ui);
    coordinates(ui);
}

}  // namespace jw::host
