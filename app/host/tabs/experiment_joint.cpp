#include <algorithm>
#include <cmath>
#include <numbers>

#include <imgui.h>

#include "app/host/tabs/experiment_tab.hpp"
#include "app/host/ui/widgets.hpp"
#include "app/panels/column/direction_sphere.hpp"
#include "app/panels/parts/formula.hpp"
#include "app/panels/parts/text_lines.hpp"
#include "app/panels/parts/theme.hpp"
#include "app/session/view/series.hpp"
#include "app/session/wording/labels.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "core/quantity/quantity.hpp"
#include "lessons/lesson/enum_words.hpp"

namespace jw::host {

namespace {

constexpr float kSlider = 230.0F;

bool uses_axis(const JointType& type) {
    return std::ranges::any_of(type.roles, [](Role r) { return r != Role::same_point && r != Role::length; });
}

void forms(const LessonUi& ui, int index, const Joint& joint) {
    if (!joint.type->uses(Role::axes_parallel) && !joint.type->uses(Role::distance_parallel)) { return; }
    note(ui, tr("Which of the three equations of p1 and p2?"));
    if (const auto form = radio_buttons(kParallelForms, joint.parallel_form, ui.px(156.0F))) {
        ui.requests.add(SetParallelForm{index, *form});
    }
    // p1 and p2 usually have the same reason, which is shown once
    std::string said;
    for (const EquationGroup& group : ui.session.view().equations) {
        if (!group.choice || group.joint != index || group.choice->reason == said) { continue; }
        said = group.choice->reason;
        note(ui, said);
    }
}

/// Draws the quality of the pair in use for every direction; dragging on the sphere turns the axis of
/// body i.
void sphere(const LessonUi& ui, int index, const Joint& joint) {
    const ParallelForm form = joint.parallel_form;
    const bool has_pair = form != ParallelForm::all_three && form != ParallelForm::pair;
    if (!has_pair || !joint.type->uses(Role::axes_parallel)) { return; }
    panels::DirectionSphere shown;
    shown.pair = form == ParallelForm::rule ? panels::PairInUse::rule
                                            : static_cast<panels::PairInUse>(forced_drop(form) + 1);
    const State& state = ui.session.step().state;
    const Mat3 A = rotation_matrix(state.p[static_cast<std::size_t>(joint.body_i)]);
    shown.axis = (A * joint.geometry.s_i_local).normalized();
    for (const Constraint& c : ui.session.step().system->constraints()) {
        if (c.joint == index && c.role == Role::axes_parallel) { shown.dropped = c.dropped; }
    }
    shown.trail = axis_directions(ui.session.story(), index, ui.session.index());

    const ImVec2 at = ImGui::GetCursorScreenPos();
    const panels::Box box{at.x, at.y, ImGui::GetContentRegionAvail().x, ui.px(180.0F)};
    ImGui::InvisibleButton("sphere", {std::max(1.0F, box.width), box.height});
    if (ImGui::IsItemVisible()) {
        const panels::Canvas canvas(ImGui::GetWindowDrawList(), ui.canvas);
        const panels::SphereView view =
            panels::direction_sphere(canvas, box, shown, render::axes_of(ui.camera));
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        const auto direction = view.direction({mouse.x, mouse.y});
        if (ImGui::IsItemActive() && direction) {
            const Vec3 s_local = A.transpose() * *direction;
            ui.requests.add(SetGeometry{index, with_axis(joint.geometry, false, s_local)});
        }
    }
}

void screw_forms(const LessonUi& ui, int index, const Joint& joint) {
    if (!joint.type->uses(Role::screw_angle)) { return; }
    note(ui, tr("Which equation ties θ to the angle? Play the motion through θ = 180° with each."));
    if (const auto form = radio_buttons(kAngleRows, joint.geometry.screw_angle_form, ui.px(130.0F))) {
        ui.requests.add(SetScrewAngleForm{index, *form});
    }
}

int components_of(Role role, ParallelForm form) {
    if (is_parallel(role)) { return form == ParallelForm::pair ? 2 : 3; }
    return traits_of(role).independent;
}

/// A check box for each single equation.
void equations(const LessonUi& ui, int index, const Joint& joint) {
    note(ui, tr("Single equations; clear a box to take the equation out of the joint:"));
    for (const Role role : joint.type->roles) {
        ImGui::PushID(static_cast<int>(role));
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(name_of_role(role, joint.parallel_form).c_str());
        const int count = components_of(role, joint.parallel_form);
        for (int k = 0; k < count; ++k) {
            ImGui::SameLine(ui.px(12.0F + 92.0F * static_cast<float>(k + 1)));
            const EquationOut equation{role, k};
            bool present = std::ranges::find(joint.without, equation) == joint.without.end();
            const char* const pair_name = k == 0 ? "1" : "2";
            const char* const name = count == 1 ? "##only" : (count == 2 ? pair_name : axis_name(k));
            if (ImGui::Checkbox(name, &present)) {
                ui.requests.add(SetEquationPresent{index, equation, present});
            }
        }
        ImGui::PopID();
    }
}

/// A symbol in a row of widgets, set as in the equations.
void symbol(const LessonUi& ui, const char* latex) {
    const panels::Canvas canvas(ImGui::GetWindowDrawList(), ui.canvas);
    const panels::Formula formula = panels::layout_formula(latex, panels::formula_fonts(canvas.fonts()));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float baseline = at.y + ImGui::GetStyle().FramePadding.y + std::round(ImGui::GetFont()->Ascent);
    panels::draw_formula(canvas, {at.x, baseline}, formula, panels::theme::kInk);
    ImGui::Dummy({formula.width, ImGui::GetFrameHeight()});
}

/// Three sliders of one vector in one row. @return true if one was moved
bool sliders(const LessonUi& ui, const char* latex, Vec3& value, double reach) {
    ImGui::PushID(latex);
    symbol(ui, latex);
    bool moved = false;
    for (int k = 0; k < 3; ++k) {
        ImGui::SameLine(k == 0 ? ui.px(66.0F) : 0.0F, ui.px(6.0F));
        // three sliders and their gaps share the width that the symbol leaves
        const float room = ImGui::GetWindowContentRegionMax().x - ui.px(66.0F);
        ImGui::SetNextItemWidth(std::clamp((room - 2.0F * ui.px(6.0F)) / 3.0F, 1.0F, ui.px(116.0F)));
        auto number = static_cast<float>(value(k));
        const auto limit = static_cast<float>(reach);
        ImGui::PushID(k);
        if (ImGui::SliderFloat("##component", &number, -limit, limit, "%.3f", ImGuiSliderFlags_AlwaysClamp)) {
            value(k) = static_cast<double>(number);
            moved = true;
        }
        ImGui::PopID();
    }
    ImGui::PopID();
    return moved;
}

void geometry(const LessonUi& ui, int index, const Joint& joint) {
    const double reach = 2.0 * extent(ui.session.as_written().mechanism);
    JointGeometry g = joint.geometry;
    bool moved = false;
    if (uses_axis(*joint.type)) {
        note(ui, tr("Axes in body coordinates (directions):"));
        Vec3 s_i = g.s_i_local.normalized();
        Vec3 s_j = g.s_j_local.normalized();
        // a vector of almost no length is not a direction: the last one stays
        if (sliders(ui, "\\mathbf{s}'_i", s_i, 1.0) && s_i.norm() > 0.05) {
            g = with_axis(g, false, s_i);
            moved = true;
        }
        if (sliders(ui, "\\mathbf{s}'_j", s_j, 1.0) && s_j.norm() > 0.05) {
            g = with_axis(g, true, s_j);
            moved = true;
        }
    }
    note(ui, tr("Points in body coordinates [m]:"));
    moved = sliders(ui, "\\mathbf{s}'_i^P", g.P_i_local, reach) || moved;
    moved = sliders(ui, "\\mathbf{s}'_j^P", g.P_j_local, reach) || moved;
    if (joint.type->uses(Role::length)) {
        auto length = static_cast<float>(g.length);
        width_beside_label(ui, tr("length [m]"), kSlider);
        if (ImGui::SliderFloat(tr("length [m]"), &length, 0.001F, static_cast<float>(reach), "%.3f")) {
            g.length = std::max(1e-6, static_cast<double>(length));
            moved = true;
        }
    }
    if (moved) { ui.requests.add(SetGeometry{index, g}); }
}

}  // namespace

void experiment_joint(const LessonUi& ui, int index) {
    const Joint& joint = ui.session.lesson().mechanism.joints[static_cast<std::size_t>(index)];
    ImGui::PushID("joint of try it");
    ImGui::PushID(index);
    section(ui, (tr("Joint {0}", joint.name) + " · " + std::string(joint.type->name)).c_str());
    forms(ui, index, joint);
    sphere(ui, index, joint);
    screw_forms(ui, index, joint);
    equations(ui, index, joint);
    geometry(ui, index, joint);
    ImGui::PopID();
    ImGui::PopID();
}

void experiment_drivers(const LessonUi& ui) {
    const Lesson& lesson = ui.session.lesson();
    if (!lesson.mechanism.drivers.empty()) { section(ui, tr("Drivers")); }
    for (std::size_t k = 0; k < lesson.mechanism.drivers.size(); ++k) {
        const Driver& driver = lesson.mechanism.drivers[k];
        const bool is_angle = unit_of(driver.measure) == Unit::radian;
        const double unit = is_angle ? std::numbers::pi / 180.0 : 1.0;
        const double reach = is_angle ? 360.0 : 2.0 * extent(ui.session.as_written().mechanism);
        TimeFunction function = driver.function;
        function.polynomial.resize(std::max<std::size_t>(2, function.polynomial.size()), 0.0);
        ImGui::PushID(static_cast<int>(k));
        ImGui::TextUnformatted(driver.name.c_str());
        bool moved = false;
        const char* const labels[] = {
            is_angle ? tr("start [deg]") : tr("start [m]"), is_angle ? tr("rate [deg/s]") : tr("rate [m/s]")};
        for (int c = 0; c < 2; ++c) {
            double& coefficient = function.polynomial[static_cast<std::size_t>(c)];
            auto number = static_cast<float>(coefficient / unit);
            const auto limit = static_cast<float>(reach);
            width_beside_label(ui, labels[c], kSlider);
            if (ImGui::SliderFloat(labels[c], &number, -limit, limit, "%.2f")) {
                coefficient = static_cast<double>(number) * unit;
                moved = true;
            }
        }
        if (moved) { ui.requests.add(SetDriver{static_cast<int>(k), function}); }
        ImGui::PopID();
    }
    const std::optional<MotionPlan> motion = shown_motion(lesson);
    if (!motion) { return; }
    auto t = static_cast<float>(ui.session.step().t);
    width_beside_label(ui, tr("time [s]"), kSlider);
    if (ImGui::SliderFloat(
            tr("time [s]"), &t, static_cast<float>(motion->from), static_cast<float>(motion->to), "%.3f")) {
        ui.requests.add(GoTo{ui.session.index_of_time(static_cast<double>(t))});
    }
}

}  // namespace jw::host
