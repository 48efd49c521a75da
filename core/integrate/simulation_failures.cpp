#include "core/integrate/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/equations/assembler.hpp"
#include "core/equations/constraint_rounding.hpp"
#include "core/motion/certificate.hpp"

/// Causes for which a simulation does not start, or ends early.
namespace jw {

namespace {

/// Largest misfit, in sizes of the scene, of a pose that is out of reach. Behind a fast driver the misfit is
/// a few sizes; if it is larger, the numbers are not a pose.
constexpr double kBlewUp = 10.0;

/// Name of the joint or driver of a row.
std::string name_of(const System& system, int row) {
    const RowOrigin origin = system.origin(row);
    const auto index = at(origin.index);
    const Mechanism& mechanism = system.mechanism();
    if (origin.kind == RowOrigin::Kind::driver) {
        return mechanism.drivers[at(system.drivers()[index].driver)].name;
    }
    return mechanism.joints[at(system.constraints()[index].joint)].name;
}

/// Relative residual of accelerations that rounding explains: 1e-16 times the condition of the matrix of λ (1
/// / pivot), times a thousand for the worst of many, and 1e-8 at least. Off the constraints, redundant rows
/// contradict each other by the drift times a condition of 1e3 at most; a run that stays on the constraints
/// is allowed one per cent at most.
double proven_up_to(double pivot, double drift, bool stays_on_constraints) {
    const double rounding = 1e-8 + 1e-13 / std::max(pivot, 1e-13) + 1e3 * drift;
    return stays_on_constraints ? std::min(rounding, 1e-2) : rounding;
}

}  // namespace

void Simulation::look_for_contradiction(const std::vector<double>& as_given) {
    double violation = block_->violation(0.0, start_.data()).first;
    if (violation <= kRepeatsUpTo) {
        look_for_contradicting_rates();
        return;
    }
    // projecting onto equations that no state satisfies may end anywhere: then the start as given is more
    // informative
    const double before = block_->violation(0.0, as_given.data()).first;
    if (before < violation) {
        violation = before;
        start_ = as_given;
    }
    contradiction_ = worst_equation(SimulationFailure::Cause::contradiction, Off::value, 0.0, start_);
}

/// Two drivers may prescribe the same start but different rates.
void Simulation::look_for_contradicting_rates() {
    constexpr double typed = 1e-4;  // at least seven typed digits, of which some are lost in computing
    double fastest = 0.0;
    const double length = extent(scene_.mechanism);
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        const double* rates = body_numbers(start_.data(), m) + 7;
        fastest = std::max({fastest, vec3(rates).norm() / length, vec3(rates + 3).norm()});
    }
    if (block_->violation(0.0, start_.data()).second <= typed * fastest + kMet) { return; }
    contradiction_ = worst_equation(SimulationFailure::Cause::contradiction, Off::rate, 0.0, start_);
}

SimulationFailure Simulation::worst_equation(
    SimulationFailure::Cause cause, Off off, double t, const std::vector<double>& y) const {
    const System system(scene_.mechanism, everything(scene_.mechanism));
    Assembler<OmegaLocal> assembler(system);
    const auto [state, motion] = unpacked(y);
    assembler.assemble_phi_and_jacobian(state, t);
    assembler.assemble_nu(t);
    VectorX values = assembler.phi();
    if (off == Off::rate) {
        values = assembler.jacobian() * assembler.layout().columns_of(state, motion) - assembler.nu();
    }
    int worst = 0;
    const auto size = [&](int row) { return std::abs(values(row)) / system.row_unit(row); };
    for (int row = 1; row < system.rows(); ++row) {
        if (size(row) > size(worst)) { worst = row; }
    }
    return {cause, t, name_of(system, worst), size(worst)};
}

SimulationFailure Simulation::failure_of(const TimeStepper& stepper) const {
    using Cause = SimulationFailure::Cause;
    if (block_->rows() > 0 && !drifts(settings_.treatment)) {
        const std::vector<double> here = flat_of(stepper.y());
        if (block_->violation(stepper.t(), here.data()).first > kContradicts) {
            return worst_equation(Cause::contradiction, Off::value, stepper.t(), here);
        }
        const auto [t, y] = stepper.tried();
        const std::vector<double> there = flat_of(y);
        const double off = block_->violation(t, there.data()).first;
        if (off > kBlewUp) { return {Cause::not_finite, t, {}, 0.0}; }
        if (off > kMet) { return worst_equation(Cause::out_of_reach, Off::value, t, there); }
    }
    SimulationFailure failure{Cause::step_too_small, stepper.t(), {}, 0.0};
    failure.law = law_at_end(stepper);
    return failure;
}

/// Source of a law that has no value or no slope where a run ends; empty if there is none.
std::string Simulation::law_at_end(const TimeStepper& stepper) const {
    // a run ends a millionth of its steps before such a point
    constexpr double beside = 1e-4;
    const auto [state, motion] = unpacked(flat_of(stepper.y()));
    return unbounded_law(scene_.loads, kinematics_of(state, motion), stepper.t(), 1, beside);
}

/// True if accelerations of the block equations satisfy all rows, including those that are left out.
bool Simulation::is_proven(double t, const std::vector<double>& y, const std::vector<double>& y_dot) {
    const double pivot = block_->smallest_pivot();
    const AccelerationResidual here = certificate_->check(*block_, *block_, t, y, y_dot);
    const double rounding = proven_up_to(pivot, here.drift, !drifts(settings_.treatment));
    // NaN fails every comparison
    return here.forces <= rounding && here.constraints <= rounding;
}

std::optional<SimulationFailure> Simulation::failure_of_proof(
    Certificate& certificate, const TimeStepper& stepper, AccelerationResidual& worst) const {
    using Cause = SimulationFailure::Cause;
    const AccelerationResidual here =
        certificate.check(integrated(), *block_, stepper.t(), stepper.y(), stepper.y_dot());
    worst.forces = std::max(worst.forces, here.forces);
    worst.constraints = std::max(worst.constraints, here.constraints);
    worst.drift = std::max(worst.drift, here.drift);
    const double rounding =
        proven_up_to(integrated().smallest_pivot(), here.drift, !drifts(settings_.treatment));
    // NaN fails every comparison
    const bool forces_hold = here.forces <= rounding;
    if (forces_hold && here.constraints <= rounding) { return std::nullopt; }
    SimulationFailure failure;
    failure.t = stepper.t();
    failure.of_accelerations = true;
    failure.cause = Cause::not_proven;
    failure.violation = here.forces;
    if (!forces_hold) { return failure; }
    // rows left out as redundant require another acceleration
    if (integrated().rows_left_out() > 0) { failure.cause = Cause::contradiction; }
    failure.violation = here.constraints;
    failure.equation_of = here.driver >= 0 ? scene_.mechanism.drivers[at(here.driver)].name
                                           : scene_.mechanism.joints[at(here.joint)].name;
    return failure;
}

/// Every stage of a step takes the nearest number of whole turns. The end of the step may lie half a turn
/// away. But if the steps of a method turn a spring by more than a quarter turn, its angle is as uncertain as
/// its turns.
std::optional<SimulationFailure> Simulation::failure_of_turns(double t, const std::vector<double>& y) const {
    constexpr double most = 0.5 * std::numbers::pi;
    if (entry_of(settings_.method).adaptive) { return std::nullopt; }
    const auto [state, motion] = unpacked(y);
    const Motion none = zero_motion(scene_.mechanism);
    SimulationFailure failure{SimulationFailure::Cause::turns_lost, t, {}, 0.0};
    for_each_angle(scene_.loads, [&](const RotationalSpring& spring) {
        const Measured angle =
            evaluate_measure(spring.angle, spring.body_i, spring.body_j, -1, state, motion, none);
        const double turn = settings_.step * std::abs(angle.rate);
        if (!spring.depends_on_angle() || turn <= std::max(most, failure.turn)) { return; }
        failure.turn = turn;
        const auto joint = std::ranges::find_if(
            scene_.mechanism.joints, [&](const Joint& of) { return acts_about(spring, of); });
        failure.equation_of = joint != scene_.mechanism.joints.end() ? joint->name : std::string();
    });
    if (failure.turn == 0.0) { return std::nullopt; }
    return failure;
}

SimulationFailure Simulation::too_many_steps(const TimeStepper& stepper) const {
    constexpr double mostly = 0.5;
    SimulationFailure failure{SimulationFailure::Cause::too_many_steps, stepper.t(), {}, 0.0};
    failure.law = law_at_end(stepper);
    failure.bound_by_stability = stepper.bound_by_stability() > mostly;
    const std::vector<double> flat = flat_of(stepper.y());
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        const double rate = vec3(body_numbers(flat.data(), m) + 10).norm();
        if (rate <= failure.fastest_rate) { continue; }
        failure.fastest_rate = rate;
        failure.fastest = scene_.mechanism.bodies[at(moving_[m])].name;
    }
    return failure;
}

}  // namespace jw
