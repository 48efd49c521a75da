#include "core/kinematics/proof/proved_equations.hpp"

#include <bit>

namespace jw {

namespace {

ProvedEquation proved(const System& system, const Constraint& c, double length) {
    const Joint& joint = system.mechanism().joints[at(c.joint)];
    const bool is_paired =
        is_parallel(c.role) && c.taken_out == 0 &&
        (joint.parallel_form == ParallelForm::rule || joint.parallel_form == ParallelForm::all_three);
    const Primitive primitive =
        is_paired ? primitive_of(c.role, joint.geometry, ParallelForm::pair) : c.primitive;
    ProvedEquation equation;
    equation.body_i = c.body_i;
    equation.body_j = c.body_j;
    equation.theta = c.theta;
    equation.left_out = is_paired ? 0U : c.left_out();
    std::visit(
        [&](const auto& p) {
            equation.primitive = p;
            equation.unit = p.unit(length);
            equation.rows = p.kEquations - std::popcount(equation.left_out);
        },
        primitive);
    return equation;
}

ProvedEquation proved(const System& system, const DriverConstraint& d, double length) {
    const Driver& driver = system.mechanism().drivers[at(d.driver)];
    ProvedEquation equation;
    std::visit([&](const auto& m) { equation.primitive = m; }, driver.measure);
    // a coordinate depends only on body j
    const bool is_coordinate = std::holds_alternative<CoordinateMeasure>(driver.measure);
    equation.body_i = is_coordinate ? driver.body_j : driver.body_i;
    equation.body_j = driver.body_j;
    if (std::holds_alternative<ThetaMeasure>(driver.measure)) { equation.theta = d.theta; }
    equation.target = &driver.function;
    equation.unit = unit_of(driver.measure, length);
    return equation;
}

}  // namespace

std::vector<ProvedEquation> proved_equations(const System& system) {
    const double length = extent(system.mechanism());
    std::vector<ProvedEquation> all;
    for (const Constraint& c : system.constraints()) { all.push_back(proved(system, c, length)); }
    for (const DriverConstraint& d : system.drivers()) { all.push_back(proved(system, d, length)); }
    for (const int body : system.moving_bodies()) {
        ProvedEquation& norm = all.emplace_back();
        norm.primitive = UnitLength{};
        norm.body_i = norm.body_j = body;
    }
    return all;
}

}  // namespace jw
