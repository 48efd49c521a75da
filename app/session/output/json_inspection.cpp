#include <algorithm>

#include "app/session/output/json_fields.hpp"
#include "app/session/view/view_equations.hpp"
#include "app/session/wording/labels.hpp"
#include "core/numerics/variants.hpp"
#include "lessons/lesson/enum_words.hpp"

namespace jw {

namespace {

/// The data of a primitive, with the names of primitives.hpp.
Json data_of(const Primitive& primitive) {
    Json data = Json::object();
    const auto add = [&](const char* name, const auto& value) { data[name] = field(value); };
    std::visit([&](const auto& p) { p.for_each_field(add); }, primitive);
    return data;
}

/// The data of a measure, with the names of drivers.hpp.
struct MeasureJson {
    Json operator()(const AngleMeasure& m) const {
        return {
            {"s_i_local", json_of(m.s_i_local)},
            {"u_i_local", json_of(m.u_i_local)},
            {"u_j_local", json_of(m.u_j_local)}};
    }
    Json operator()(const DisplacementMeasure& m) const {
        return {
            {"s_i_local", json_of(m.s_i_local)},
            {"B_i_local", json_of(m.B_i_local)},
            {"B_j_local", json_of(m.B_j_local)}};
    }
    Json operator()(const SquaredDistanceMeasure& m) const {
        return {{"P_i_local", json_of(m.P_i_local)}, {"P_j_local", json_of(m.P_j_local)}};
    }
    Json operator()(const CoordinateMeasure& m) const {
        constexpr const char* names[] = {"x", "y", "z", "e0", "e1", "e2", "e3"};
        return {{"coordinate", names[m.coordinate]}};
    }
    Json operator()(const ThetaMeasure& /*m*/) const { return Json::object(); }
};

const char* measure_name(const Measure& measure) {
    return std::visit(
        Overloaded{
            [](const AngleMeasure&) { return "angle"; },
            [](const DisplacementMeasure&) { return "displacement"; },
            [](const SquaredDistanceMeasure&) { return "squared distance"; },
            [](const CoordinateMeasure&) { return "coordinate"; },
            [](const ThetaMeasure&) { return "theta"; },
        },
        measure);
}

Json constraints_of(const System& system) {
    const Mechanism& mechanism = system.mechanism();
    return list_of(system.constraints(), [&](const Constraint& c) -> Json {
        const Joint& joint = mechanism.joints[at(c.joint)];
        return {
            {"joint", joint.name},
            {"type", joint.type->name},
            {"primitive", name_of_role(c.role, joint.parallel_form)},
            {"formula", equation_text(system, c).plain},
            {"body_i", mechanism.bodies[at(c.body_i)].name},
            {"body_j", mechanism.bodies[at(c.body_j)].name},
            {"first_row", c.first_row},
            {"equations", c.equations},
            {"dropped", c.dropped < 0 ? Json() : Json(axis_name(c.dropped))},
            {"unit", number(c.unit)},
            {"data", data_of(c.primitive)}};
    });
}

Json drivers_of(const System& system, double t) {
    const Mechanism& mechanism = system.mechanism();
    return list_of(system.drivers(), [&](const DriverConstraint& d) -> Json {
        const Driver& driver = mechanism.drivers[at(d.driver)];
        const TimeFunction::Value target = target_of(driver.measure, driver.function, t);
        return {
            {"name", driver.name},
            {"measure", measure_name(driver.measure)},
            {"body_i", mechanism.bodies[at(driver.body_i)].name},
            {"body_j", mechanism.bodies[at(driver.body_j)].name},
            {"joint", driver.joint < 0 ? Json() : Json(mechanism.joints[at(driver.joint)].name)},
            {"row", d.row},
            {"target", number(target.f)},
            {"target_dot", number(target.f_dot)},
            {"target_ddot", number(target.f_ddot)},
            {"data", std::visit(MeasureJson{}, driver.measure)}};
    });
}

Json choices_of(const System& system, const State& state) {
    Json list = Json::array();
    for (std::size_t k = 0; k < system.constraints().size(); ++k) {
        const Constraint& c = system.constraints()[k];
        if (!is_parallel(c.role)) { continue; }
        const RowChoice choice = explain_choice(system, static_cast<int>(k), state, -1);
        const ChoiceView view = choice_view_of(choice);
        const Joint& joint = system.mechanism().joints[at(c.joint)];
        list.push_back(
            {{"joint", joint.name},
             {"primitive", name_of_role(c.role, joint.parallel_form)},
             {"form", view.form},
             {"dropped", c.dropped < 0 ? Json() : Json(axis_name(c.dropped))},
             {"s_i", json_of(choice.s_i)},
             {"condition_without_xyz", list_of(choice.pair_condition, number)},
             {"condition", number(choice.form_condition)},
             {"reason", view.reason}});
    }
    return list;
}

Json rows_of(const Inspection& inspection) {
    const System& system = *inspection.system;
    Json list = Json::array();
    for (int row = 0; row < static_cast<int>(inspection.phi.size()); ++row) {
        const Constraint* const c = constraint_of(system, row);
        const std::string component =
            c != nullptr ? component_name(*c, system.origin(row).component) : std::string();
        list.push_back(
            {{"label", row_label(system, row)},
             {"owner", row_owner(system, row)},
             {"component", text_or_null(component)},
             {"phi", number(inspection.phi(row))},
             {"nu", number(inspection.nu(row))},
             {"gamma", number(inspection.gamma(row))}});
    }
    return list;
}

Json thetas_of(const System& system, const State& state, const Motion& velocity) {
    const Mechanism& mechanism = system.mechanism();
    const std::vector<int> thetas = mechanism.theta_indices();
    return list_of(system.active_thetas(), [&](int active) -> Json {
        const auto theta = at(active);
        const auto k = at(std::ranges::find(thetas, active) - thetas.begin());
        return {
            {"joint", mechanism.joints[k].name},
            {"theta", number(state.theta[theta])},
            {"theta_dot", number(velocity.theta_dot[theta])}};
    });
}

/// Φq with all of its zeros; for large systems only the nonzero entries, as three lists.
Json jacobian_of(const Inspection& inspection) {
    const SparseRows& jacobian = inspection.jacobian;
    if (is_shown_dense(inspection)) {
        MatrixX dense(inspection.phi.size(), jacobian.columns);
        jacobian.write(dense);
        return json_of(dense);
    }
    Json row = Json::array();
    Json column = Json::array();
    Json value = Json::array();
    for (std::size_t r = 0; r < jacobian.rows.size(); ++r) {
        jacobian.for_each_entry(jacobian.rows[r], [&](int c, double entry) {
            if (entry == 0.0) { return; }
            row.push_back(r);
            column.push_back(c);
            value.push_back(number(entry));
        });
    }
    return {
        {"rows", jacobian.rows.size()},
        {"columns", jacobian.columns},
        {"row", std::move(row)},
        {"column", std::move(column)},
        {"value", std::move(value)}};
}

Json body_json(const DynamicsView::Body& body) {
    return {
        {"name", body.name},
        {"mass", number(body.mass)},
        {"J_local", json_of(MatrixX(body.J_local))},
        {"f", json_of(body.f)},
        {"n_local", json_of(body.n_local)},
        {"r_ddot", json_of(body.r_ddot)},
        {"omega_local_dot", json_of(body.omega_local_dot)}};
}

Json multiplier_json(const DynamicsView::Multiplier& multiplier) {
    return {
        {"owner", multiplier.owner},
        {"row", multiplier.row},
        {"lambda", number(multiplier.lambda)},
        {"left_out", multiplier.left_out}};
}

}  // namespace

Json json_of(const std::optional<DynamicsView>& dynamics) {
    if (!dynamics) { return {}; }
    return {
        {"bodies", list_of(dynamics->bodies, body_json)},
        {"multipliers", list_of(dynamics->multipliers, multiplier_json)},
        {"M", json_of(dynamics->M)},
        {"jacobian", json_of(dynamics->jacobian)},
        {"Q", json_of(dynamics->Q)},
        {"acceleration", json_of(dynamics->acceleration)},
        {"lambda", json_of(dynamics->lambda)},
        {"gamma", json_of(dynamics->gamma)},
        {"residual", number(dynamics->residual)},
        {"kinetic_energy", number(dynamics->energy.kinetic)},
        {"potential_energy", number(dynamics->energy.potential)},
        {"momentum", json_of(dynamics->momentum)},
        {"angular_momentum", json_of(dynamics->angular_momentum)}};
}

Json json_of(const Inspection& inspection, const Lesson& lesson) {
    const System& system = *inspection.system;
    const auto column_json = [](const ColumnName& name) -> Json {
        return {{"owner", name.owner}, {"coordinate", name.coordinate}};
    };
    return {
        {"format", "jointwise inspect"},
        {"version", kJsonVersion},
        {"lesson", {{"file", lesson.file_name}, {"title", lesson.title}}},
        {"moment", inspection.moment},
        {"step", inspection.step < 0 ? Json() : Json(inspection.step)},
        {"time_s", number(inspection.t)},
        {"coordinates", name_of_choice(inspection.choice)},
        {"length_unit_m", number(system.length_unit())},
        {"bodies", json_of(lesson.mechanism, inspection.state, inspection.velocity)},
        {"artificial_coordinates", thetas_of(system, inspection.state, inspection.velocity)},
        {"constraints", constraints_of(system)},
        {"drivers", drivers_of(system, inspection.t)},
        {"rows", rows_of(inspection)},
        {"columns", list_of(column_names(system, inspection.choice), column_json)},
        {"phi", json_of(inspection.phi)},
        {"jacobian", jacobian_of(inspection)},
        {"nu", json_of(inspection.nu)},
        {"gamma", json_of(inspection.gamma)},
        {"singular_values", inspection.rank.has_spectrum ? json_of(inspection.singular_values) : Json()},
        {"singular_value_error", number(inspection.singular_value_error)},
        {"singular_values_sound", inspection.sound},
        {"position_residual", json_of(inspection.residuals.position)},
        {"velocity_residual", json_of(inspection.residuals.velocity)},
        {"rank", json_of(inspection.rank, system, judgements_of(inspection))},
        {"choices", choices_of(system, inspection.state)},
        {"dynamics", json_of(inspection.dynamics)},
    };
}

}  // namespace jw
