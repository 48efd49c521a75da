#include "core/kinematics/kinematic_residuals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/jets/body_kinematics.hpp"
#include "core/poses/rank.hpp"

namespace jw {

namespace {

using C = OmegaGlobal;

// Newton's method stops at 1e-13 times the scene's coordinates; the rows are evaluated in other coordinates
// here
constexpr double kPosition = 1e-12;
constexpr double kRoundings = 1e4;

struct Terms {
    double value = 0.0;
    double rate = 0.0;
    double bias = 0.0;
};

Theta theta_of(int theta, const State& state, const Motion& motion) {
    if (theta < 0) { return {}; }
    return {state.theta[at(theta)], motion.theta_dot[at(theta)]};
}

/// Calls `use(row, terms, target)` for every equation: `terms` along `motion`, `target` from a driver's
/// function.
template <class Use>
void for_each_row(const System& system, const State& state, const Motion& motion, double t, const Use& use) {
    std::vector<BodyKinematics<C>> bodies;
    for (std::size_t b = 0; b < state.r.size(); ++b) {
        bodies.push_back(kinematics_at<C>(state.r[b], state.p[b], motion.r_dot[b], motion.omega_local[b]));
    }
    for (const Constraint& c : system.constraints()) {
        const auto visit = [&](const auto& primitive) {
            const auto jet = equations<Content::motion>(
                primitive, bodies[at(c.body_i)], bodies[at(c.body_j)], theta_of(c.theta, state, motion));
            int row = c.first_row;
            for (int k = 0; k < jet.kDim; ++k) {
                if (!c.has_row(k)) { continue; }
                use(row++, Terms{jet.value(k), jet.rate(k), jet.bias(k)}, TimeFunction::Value{});
            }
        };
        std::visit(visit, c.primitive);
    }
    for (const DriverConstraint& c : system.drivers()) {
        const Driver& d = system.mechanism().drivers[at(c.driver)];
        const TimeFunction::Value target = target_of(d.measure, d.function, t);
        const auto visit = [&](const auto& measure) {
            const auto jet = measured<Content::motion>(
                measure, bodies[at(d.body_i)], bodies[at(d.body_j)], theta_of(c.theta, state, motion));
            use(c.row, Terms{driver_residual(d.measure, jet.value(0), target.f), jet.rate(0), jet.bias(0)},
                target);
        };
        std::visit(visit, d.measure);
    }
}

/// Largest coordinate of a motion in the scene's units.
double size_of(const System& system, const Motion& motion) {
    double size = 0.0;
    for (const int body : system.moving_bodies()) {
        size = std::max(
            {size, motion.r_dot[at(body)].norm() / system.length_unit(),
             motion.omega_local[at(body)].norm()});
    }
    for (const int theta : system.active_thetas()) {
        size = std::max(size, std::abs(motion.theta_dot[at(theta)]));
    }
    return size;
}

double largest_coordinate(const System& system, const State& state) {
    double largest = 1.0;
    for (const int body : system.moving_bodies()) {
        largest = std::max(largest, state.r[at(body)].norm() / system.length_unit());
    }
    return largest;
}

}  // namespace

KinematicResiduals residuals_of(
    const System& system, const State& state, const Motion& velocity, const Motion& acceleration, double t) {
    KinematicResiduals out;
    double nu = 0.0;
    double gamma = 0.0;
    VectorX right(system.rows());
    for_each_row(
        system, state, velocity, t, [&](int row, const Terms& terms, const TimeFunction::Value& target) {
            const double unit = system.row_unit(row);
            const auto keep_largest = [&](double& largest, double value) {
                largest = std::isnan(value) ? HUGE_VAL : std::max(largest, std::abs(value) / unit);
            };
            keep_largest(out.position.residual, terms.value);
            keep_largest(out.velocity.residual, terms.rate - target.f_dot);
            right(row) = target.f_ddot - terms.bias;
            keep_largest(nu, target.f_dot);
            keep_largest(gamma, right(row));
        });
    // Φq q̈ is the rate that Φ would have if q̈ were its velocities
    for_each_row(
        system, state, acceleration, t, [&](int row, const Terms& terms, const TimeFunction::Value&) {
            out.acceleration.residual =
                std::max(out.acceleration.residual, std::abs(terms.rate - right(row)) / system.row_unit(row));
        });

    const double reach = largest_coordinate(system, state);
    out.position.bound = kPosition * reach;
    const double relative =
        kRoundings * std::numeric_limits<double>::epsilon() * reach + kErrorFactor * out.position.residual;
    out.velocity.bound = relative * (size_of(system, velocity) + nu + 1.0);
    out.acceleration.bound = relative * (size_of(system, acceleration) + gamma + 1.0);
    return out;
}

}  // namespace jw
