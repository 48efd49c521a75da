#include "app/session/view/view_equations.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "app/session/wording/labels.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "core/equations/assembler.hpp"

namespace jw {

namespace {

bool is_redundant(const RankReport* report, int row) {
    return report != nullptr &&
           std::ranges::any_of(report->redundant_rows, [row](const RedundantRow& r) { return r.row == row; });
}

/// Size of a component of the unit axis, without its sign: "0.8"
std::string size_of(int component, const ChoiceView& choice) {
    return number_text(choice.axis_size[at(component)], 3);
}

std::string condition_of(int component, const ChoiceView& choice) {
    return number_text(choice.pair_condition[at(component)], 3);
}

std::string reason_of_rule(const RowChoice& choice, const ChoiceView& view) {
    const int dropped = choice.dropped;
    const auto largest = static_cast<int>(std::ranges::max_element(view.axis_size) - view.axis_size.begin());
    const std::string name = axis_name(dropped);
    if (dropped == largest) {
        return tr(
            "The {0} equation is left out, because no component of sᵢ is larger than {0} ({1}): both "
            "equations kept contain it, and their condition number is {2}.",
            name, size_of(dropped, view), condition_of(dropped, view));
    }
    return tr(
        "The {0} equation is still left out: the {1} component of sᵢ is now larger ({2} against {3}), but "
        "not by enough to switch. Condition number {4}.",
        name, axis_name(largest), size_of(largest, view), size_of(dropped, view),
        condition_of(dropped, view));
}

/// Names of the components in a bit mask: "x and y" or "a".
std::string components_of(unsigned mask, ParallelForm form) {
    constexpr std::array pair{"a", "b"};
    std::vector<std::string> names;
    for (int k = 0; k < 3; ++k) {
        if (((mask >> k) & 1U) == 0) { continue; }
        names.emplace_back(form == ParallelForm::pair ? pair[at(k)] : axis_name(k));
    }
    return listed(names);
}

/// Reason for equations that `without` takes out, in addition to those that the form leaves out.
std::string reason_of_taken_out(const RowChoice& choice, const ChoiceView& view) {
    const unsigned all = choice.form == ParallelForm::pair ? 0b11U : 0b111U;
    const unsigned dropped = choice.dropped >= 0 ? 1U << choice.dropped : 0U;
    const unsigned kept = all & ~(choice.taken_out | dropped);
    const std::string out = components_of(choice.taken_out, choice.form);
    std::string text = tr_count(
        std::popcount(choice.taken_out), "The lesson takes out the equation {1}",
        "The lesson takes out the equations {1}", out);
    if ((dropped & ~choice.taken_out) != 0) {
        text = tr("{0}, and {1} is left out as well", text, components_of(dropped, choice.form));
    }
    if (kept == 0) { return tr("{0}: none is kept.", text); }
    const std::string left = components_of(kept, choice.form);
    if (std::popcount(kept) == 1) {
        return tr(
            "{0}: one is kept, {1}, where two independent ones are needed to keep two directions parallel.",
            text, left);
    }
    if (!std::isfinite(view.form_condition)) {
        return tr(
            "{0}: two are kept, {1}, and they have lost rank here: one of them is redundant.", text, left);
    }
    return tr(
        "{0}: two are kept, {1}, with the condition number {2}.", text, left,
        number_text(view.form_condition, 3));
}

std::string reason_of(const RowChoice& choice, const ChoiceView& view) {
    if (choice.taken_out != 0) { return reason_of_taken_out(choice, view); }
    switch (choice.form) {
        case ParallelForm::rule: return reason_of_rule(choice, view);
        case ParallelForm::all_three:
            return tr("All three equations are kept on purpose: one of them is redundant.");
        case ParallelForm::pair:
            return tr(
                "Two equations with vectors a and b perpendicular to sᵢ are used instead: their condition "
                "number is {0} for any direction of sᵢ.",
                number_text(choice.form_condition, 3));
        case ParallelForm::drop_x:
        case ParallelForm::drop_y:
        case ParallelForm::drop_z: break;
    }
    const std::string name = axis_name(choice.dropped);
    const std::string size = size_of(choice.dropped, view);
    if (!std::isfinite(view.form_condition)) {
        return tr(
            "The lesson leaves out the {0} equation; the {0} component of sᵢ has the size {1}. The two "
            "equations kept have lost rank: one of them is redundant.",
            name, size);
    }
    return tr(
        "The lesson leaves out the {0} equation; the {0} component of sᵢ has the size {1}. The two equations "
        "kept have the condition number {2}.",
        name, size, number_text(view.form_condition, 3));
}

}  // namespace

ChoiceView choice_view_of(const RowChoice& choice) {
    ChoiceView view;
    view.form = name_of_form(choice.form);
    for (std::size_t k = 0; k < 3; ++k) {
        view.axis_size[k] = std::abs(choice.s_i(static_cast<Eigen::Index>(k)));
        view.pair_condition[k] = choice.pair_condition[k];
    }
    view.dropped = choice.dropped;
    view.switched = choice.previous >= 0 && choice.previous != choice.dropped;
    view.form_condition = choice.form_condition;
    view.reason = reason_of(choice, view);
    return view;
}

std::vector<RowChoice> choices_of_joint(
    const System& system, int joint, const State& state, const System* before) {
    const auto dropped_before = [before](const Constraint& c) {
        if (before == nullptr) { return -1; }
        const auto same = std::ranges::find_if(before->constraints(), [&c](const Constraint& b) {
            return b.joint == c.joint && b.role == c.role;
        });
        return same == before->constraints().end() ? -1 : same->dropped;
    };
    std::vector<RowChoice> choices;
    for (std::size_t k = 0; k < system.constraints().size(); ++k) {
        const Constraint& c = system.constraints()[k];
        if (c.joint == joint && is_parallel(c.role)) {
            choices.push_back(explain_choice(system, static_cast<int>(k), state, dropped_before(c)));
        }
    }
    return choices;
}

std::vector<EquationGroup> equations_of_joint(
    const Step& step, int joint, const std::vector<RowChoice>& choices, const RankReport* report) {
    std::vector<EquationGroup> groups;
    std::size_t next_choice = 0;
    int equation = 0;
    for (const Constraint& c : step.system->constraints()) {
        if (c.joint != joint) { continue; }
        const EquationText text = equation_text(*step.system, c);
        EquationGroup group{text.primitive, text.formula, text.plain, text.unit, {},
                            std::nullopt,   joint,        c.role};
        const VectorX values = values_of(c, step.state);
        int row = c.first_row;
        for (int k = 0; k < c.equations; ++k) {
            EquationRow entry;
            entry.component = component_name(c, k);
            entry.equation = equation++;
            entry.value = values(k);
            entry.row = c.has_row(k) ? row++ : -1;
            if (entry.row < 0) {
                entry.status = EquationRow::Status::dropped;
            } else if (is_redundant(report, entry.row)) {
                entry.status = EquationRow::Status::redundant;
            }
            group.rows.push_back(entry);
        }
        if (is_parallel(c.role) && next_choice < choices.size()) {
            group.choice = choice_view_of(choices[next_choice++]);
        }
        groups.push_back(std::move(group));
    }
    return groups;
}

std::vector<EquationGroup> open_equations(const Step& now, const Step& after, int joint) {
    Step coming = now;
    coming.system = after.system;
    std::vector<EquationGroup> groups = equations_of_joint(coming, joint, {}, nullptr);
    for (EquationGroup& group : groups) {
        for (EquationRow& row : group.rows) {
            row.row = -1;
            row.status = EquationRow::Status::open;
        }
    }
    return groups;
}

EquationGroup equation_of_driver(const Step& step, int driver, const RankReport* report) {
    const System& system = *step.system;
    const auto found = std::ranges::find(system.drivers(), driver, &DriverConstraint::driver);
    const EquationText text = driver_text(system.mechanism().drivers[at(driver)]);
    EquationGroup group{text.primitive, text.formula, text.plain, text.unit, {}, std::nullopt};
    Assembler<OmegaLocal> assembler(system);
    assembler.assemble_phi_and_jacobian(step.state, step.t);
    EquationRow row;
    row.value = assembler.phi()(found->row);
    row.row = found->row;
    if (is_redundant(report, row.row)) { row.status = EquationRow::Status::redundant; }
    group.rows.push_back(row);
    return group;
}

}  // namespace jw
