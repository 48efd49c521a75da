#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/kinematics/kinematics.hpp"
#include "tests/hard/cases.hpp"
#include "tests/hard/variants.hpp"

namespace jw::hard {

namespace {

/// The lesson's parallelogram assembled by hand with its crank at φ, turned by 1 rad/s and 1 rad/s².
Mechanism parallelogram_at(Mechanism mechanism, double phi) {
    const Vec3 along(std::cos(phi), 0.0, std::sin(phi));
    const Vec4 p = euler_parameters_of(-Vec3::UnitY(), phi);
    mechanism.bodies[1].p = mechanism.bodies[3].p = p;
    mechanism.bodies[2].p = Vec4::Unit(0);
    mechanism.bodies[2].r = mechanism.bodies[1].r + mechanism.joints[1].geometry.P_i_local.x() * along;
    const Joint& A = mechanism.joints[0];
    TimeFunction drive;
    drive.polynomial = {phi, 1.0, 0.5};
    mechanism.drivers = {{"drive", 0, A.body_i, A.body_j, angle_of(A), drive}};
    return mechanism;
}

struct Errors {
    double condition = 0.0;
    double naive_velocity = 0.0;
    double velocity = 0.0;
    double naive_acceleration = 0.0;
    double acceleration = 0.0;
};

/// Closed form: crank and rocker turn alike, at 1 rad/s and 1 rad/s², the coupler not at all.
Errors errors_at(const Mechanism& lesson, double phi) {
    const Mechanism mechanism = parallelogram_at(lesson, phi);
    const System system(mechanism, everything(mechanism));
    Kinematics<OmegaLocal> kinematics(system);
    kinematics.set_state(start_state(mechanism), 0.0);
    const Motion velocity = kinematics.solve_velocity(zero_motion(mechanism)).velocity;
    Motion exact = zero_motion(mechanism);
    exact.omega_local[1] = exact.omega_local[3] = -Vec3::UnitY();
    exact.r_dot[2] = mechanism.joints[1].geometry.P_i_local.x() * Vec3(-std::sin(phi), 0.0, std::cos(phi));
    const Motion acceleration = kinematics.solve_acceleration(exact).acceleration;

    const Assembler<OmegaLocal>& assembler = kinematics.assembler();
    const VectorX naive_velocity = by_normal_equations(assembler.jacobian(), assembler.nu());
    const VectorX naive_acceleration = by_normal_equations(assembler.jacobian(), assembler.gamma());
    const auto rocker = [](const VectorX& columns) -> Vec3 { return columns.segment<3>(15); };
    const VectorX sigma = verdict_on(mechanism).singular_values;
    const Vec3 turning = -Vec3::UnitY();
    return {
        sigma(0) / sigma(17), (rocker(naive_velocity) - turning).norm(),
        (velocity.omega_local[3] - turning).norm(), (rocker(naive_acceleration) - turning).norm(),
        (acceleration.omega_local[3] - turning).norm()};
}

}  // namespace

Result towards_a_change_point() {
    constexpr double kRounding = 1e-16;
    const Mechanism lesson = assembled_mechanism("loops/parallelogram.toml");
    Result result;
    result.naive =
        "the condition number of JᵀJ is the square of that of J, so twice as many digits are lost.";
    result.ours = "only as many digits are lost as the condition number has.";
    Errors worst;  // in condition numbers times rounding
    for (int power = 1; power <= 7; ++power) {
        const Errors errors = errors_at(lesson, std::pow(10.0, -power));
        const double lost = errors.condition * kRounding;
        worst.naive_velocity = std::max(worst.naive_velocity, errors.naive_velocity / lost);
        worst.velocity = std::max(worst.velocity, errors.velocity / lost);
        worst.naive_acceleration = std::max(worst.naive_acceleration, errors.naive_acceleration / lost);
        worst.acceleration = std::max(worst.acceleration, errors.acceleration / lost);
        worst.condition = errors.condition;
        result.measurements.push_back(of_both(
            "error of the velocity at 10^-" + std::to_string(power) + " rad [rad/s]", errors.naive_velocity,
            any(), errors.velocity, any()));
    }
    // 11 / φ, from the singular values 3.2 and 0.3 φ
    result.measurements.push_back(of_ours("condition number at 10^-7 rad", worst.condition, at_most(2e8)));
    // entries of Φq and of p are rounded once or twice each, 18 of them in a row
    result.measurements.push_back(of_both(
        "worst error over condition · 1e-16: velocity", worst.naive_velocity, at_least(1e4), worst.velocity,
        at_most(10.0)));
    result.measurements.push_back(of_both(
        "the same: acceleration", worst.naive_acceleration, at_least(1e4), worst.acceleration,
        at_most(10.0)));
    return result;
}

}  // namespace jw::hard
