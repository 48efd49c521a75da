#include "core/quantity/residuals.hpp"

#include <bit>

#include "core/equations/assembler.hpp"

namespace jw {

namespace {

/// An equation of a system: its value, its size, and its row if it has one.
struct Equation {
    double value = 0.0;
    double unit = 1.0;
    int row = -1;
};

std::optional<Equation> equation_of(const ResidualQuantity& q, const Instant& instant) {
    const System& system = *instant.system;
    for (const Constraint& c : system.constraints()) {
        if (c.joint != q.joint || c.role != q.role || q.component >= c.equations) { continue; }
        Equation found{values_of(c, instant.state)(q.component), c.unit, -1};
        const unsigned before = ~c.left_out() & ((1U << q.component) - 1U);
        if (c.has_row(q.component)) { found.row = c.first_row + std::popcount(before); }
        return found;
    }
    for (const DriverConstraint& d : system.drivers()) {
        if (d.driver != q.driver) { continue; }
        const Driver& driver = system.mechanism().drivers[at(d.driver)];
        const Motion still = zero_motion(system.mechanism());
        const double measured =
            evaluate_measure(
                driver.measure, driver.body_i, driver.body_j, d.theta, instant.state, still, still)
                .value;
        const double target = target_of(driver.measure, driver.function, instant.t).f;
        return Equation{driver_residual(driver.measure, measured, target), d.unit, d.row};
    }
    return std::nullopt;
}

}  // namespace

QuantityValue residual_at(const ResidualQuantity& quantity, const Instant& instant, int highest) {
    QuantityValue out;
    const std::optional<Equation> equation = equation_of(quantity, instant);
    if (!equation) {
        out.absences.fill(Absence::not_there);
        return out;
    }
    out.derivatives[0] = equation->value / equation->unit;
    if (highest == 0 || equation->row < 0) { return out; }
    Assembler<OmegaLocal> assembler(*instant.system);
    assembler.assemble_phi_and_jacobian(instant.state, instant.t);
    const Layout<OmegaLocal>& layout = assembler.layout();
    const auto change = [&](const Motion& motion, const VectorX& asked) {
        const auto row = static_cast<Eigen::Index>(equation->row);
        return (assembler.jacobian().row(row).dot(layout.columns_of(instant.state, motion)) - asked(row)) /
               equation->unit;
    };
    assembler.assemble_nu(instant.t);
    out.derivatives[1] = change(instant.velocity, assembler.nu());
    out.absences[1] = Absence::none;
    out.absences[2] = Absence::no_acceleration;
    if (highest > 1 && instant.acceleration) {
        assembler.assemble_gamma(instant.state, instant.velocity, instant.t);
        out.derivatives[2] = change(*instant.acceleration, assembler.gamma());
        out.absences[2] = Absence::none;
    }
    return out;
}

}  // namespace jw
