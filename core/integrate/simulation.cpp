#include "core/integrate/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/equations/constraint_rounding.hpp"
#include "core/integrate/explicit_integrator.hpp"
#include "core/integrate/independent_coordinates.hpp"
#include "core/integrate/radau.hpp"
#include "core/integrate/semi_implicit.hpp"
#include "core/motion/certificate.hpp"
#include "core/motion/dense/dense_equations.hpp"
#include "core/motion/forces.hpp"
#include "core/motion/singular_steps.hpp"
#include "core/motion/spring_turns.hpp"
#include "core/motion/start_velocities.hpp"
#include "core/motion/time_events.hpp"
#include "core/motion/tree/tree_equations.hpp"

namespace jw {

namespace {

void require(const SimulationSettings& settings) {
    const MethodName& method = entry_of(settings.method);
    const std::string_view unfit = why_not(settings.method, settings.treatment);
    if (!unfit.empty()) { throw std::invalid_argument(std::string(unfit)); }
    if (settings.dense && method.kind != MethodKind::runge_kutta) {
        throw std::invalid_argument(
            "a coordinate choice needs an explicit Runge-Kutta method; expected explicit-8, explicit-5, rk4 "
            "or euler");
    }
    if (method.adaptive && !is_tolerance(settings.tolerance)) {
        throw std::invalid_argument(std::string("the tolerance is out of range; ") + kToleranceRange);
    }
    if (!method.adaptive && !(settings.step > 0.0)) {
        throw std::invalid_argument("the step must be positive");
    }
    if (settings.formulation != Formulation::joints) { return; }
    if (method.kind == MethodKind::semi_implicit) {
        throw std::invalid_argument(
            "the semi-implicit method moves bodies; expected another method, or bodies");
    }
    if (drifts(settings.treatment)) {
        throw std::invalid_argument(
            "in joint coordinates only the loops can drift; expected treatment projection");
    }
}

/// True if joint coordinates are an option. Fixed steps and drift are for teaching and need bodies; with a
/// tolerance only the result counts.
bool joints_may_pay(const SimulationSettings& settings, bool masses_are_apart) {
    if (settings.formulation != Formulation::automatic) {
        return settings.formulation == Formulation::joints;
    }
    return entry_of(settings.method).adaptive && !drifts(settings.treatment) && !masses_are_apart;
}

/// Largest number of loop rows in joint coordinates: their choice compares each row with all others, which
/// takes time and memory.
constexpr int kMostLoopRows = 1000;
/// Products per body beyond which the loop rows in joint coordinates cost more than a whole evaluation in
/// coordinates of the bodies (7 to 10 thousand instructions a body, about three per product).
constexpr double kMostProducts = 2500.0;

/// Relative error of accelerations in joint coordinates that is always accepted: rounding times a condition
/// of 1e3, and a factor of ten. No tolerance demands less.
constexpr double kDigitsKept = 1e-11;
/// Relative error of accelerations that is accepted, as a share of the tolerance.
constexpr double kShareOfTolerance = 0.1;

}  // namespace

Simulation::Simulation(const Mechanism& mechanism, const Loads& loads, const SimulationSettings& settings)
    : scene_(centroidal(mechanism, loads)), settings_(settings) {
    require(settings);
    block_ = block_equations(scene_, stabilisation());
    moving_ = moving_bodies_of(mechanism);
    order_of_body_.assign(mechanism.bodies.size(), -1);
    for (std::size_t m = 0; m < moving_.size(); ++m) { order_of_body_[at(moving_[m])] = static_cast<int>(m); }
    start_ = flat_start(scene_.mechanism);
    block_->choose_rows(0.0, start_.data());
    const std::vector<double> as_given = start_;
    block_->project(0.0, start_.data());
    look_for_contradiction(as_given);
    if (!contradiction_) { keep_given_velocities(mechanism, scene_, *block_, start_); }
    if (settings.dense) {
        other_ = dense_equations(scene_, *settings.dense, stabilisation());
    } else if (joints_may_pay(settings, block_->masses_are_apart())) {
        take_joints();
    }
}

/// Implicit methods use joint coordinates only if no loop is left; independent coordinates handle loops
/// better.
void Simulation::take_joints() {
    auto tree = std::make_unique<TreeEquations>(scene_, start_);
    const bool wanted = settings_.formulation == Formulation::joints;
    const bool is_implicit = entry_of(settings_.method).kind == MethodKind::radau;
    if (wanted && is_implicit && tree->rows() > 0) {
        throw std::invalid_argument(
            "implicit methods take joint coordinates only where there are no loops and no drivers; "
            "expected an explicit method, or bodies");
    }
    const auto pays = [&] {
        if (tree->rows() == 0) { return true; }
        if (is_implicit || tree->rows() > kMostLoopRows) { return false; }
        const int freedoms = block_->velocities() - (block_->rows() - block_->rows_left_out());
        const double kept = static_cast<double>(tree->velocities() - freedoms) / tree->rows();
        return tree->products_of_rows(std::clamp(kept, 0.0, 1.0)) <= kMostProducts * tree->bodies();
    };
    if (wanted || (pays() && keeps_digits(*tree))) { other_ = std::move(tree); }
}

/// True if accelerations agree with those of the block equations at the start, where both know the rows.
/// Articulated inertias add those of heavy bodies to those of the light ones that carry them, which loses
/// digits; the block equations keep both apart.
bool Simulation::keeps_digits(TreeEquations& tree) {
    std::vector<double> y(at(tree.size()));
    std::vector<double> y_dot(y.size());
    tree.from_flat(start_.data(), y.data());
    tree.choose_rows(0.0, y.data());
    tree.evaluate(0.0, y.data(), y_dot.data());
    std::vector<ProbedBody> found(moving_.size());
    tree.motion_of_bodies(0.0, y.data(), y_dot.data(), found);
    std::vector<double> flat_dot(start_.size());
    block_->choose_rows(0.0, start_.data());
    block_->evaluate(0.0, start_.data(), flat_dot.data());
    const double per_extent = 1.0 / extent(scene_.mechanism);
    double off = 0.0;
    // in equilibrium, accelerations are rounding errors of those that gravity would cause
    double size = per_extent * scene_.loads.gravity.norm();
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        const double* six = body_numbers(flat_dot.data(), m) + 7;
        const Vec3 turn_off = found[m].A.transpose() * found[m].alpha - vec3(six + 3);
        off = std::max({off, per_extent * (found[m].r_ddot - vec3(six)).norm(), turn_off.norm()});
        size = std::max({size, per_extent * vec3(six).norm(), vec3(six + 3).norm()});
    }
    // at a singular pose neither is a reference for the other
    if (block_->smallest_pivot() < kTooNear) { return true; }
    return off <= std::max(kDigitsKept, kShareOfTolerance * settings_.tolerance) * size;
}

std::vector<double> Simulation::flat_of(const std::vector<double>& y) const {
    std::vector<double> flat(start_.size());
    integrated().to_flat(y.data(), flat.data());
    return flat;
}

std::vector<double> Simulation::integrated_start() const {
    std::vector<double> y(at(integrated().size()));
    integrated().from_flat(start_.data(), y.data());
    return y;
}

std::unique_ptr<TimeStepper> Simulation::stepper(double t, std::vector<double> start, double end) const {
    IntegrationOptions options;
    if (end > 0.0) { options.duration = end; }
    options.longest_step = half_of_fastest_swing(scene_);
    options.tolerance = settings_.tolerance;
    options.length_scale = extent(scene_.mechanism);
    options.project = !drifts(settings_.treatment);
    if (!entry_of(settings_.method).adaptive) { options.fixed_step = settings_.step; }
    if (counts_turns()) { options.most_turn = kCountedTurn; }
    const auto explicit_one = [&](const RungeKuttaTable& table) {
        return std::make_unique<ExplicitIntegrator>(integrated(), table, options, t, std::move(start));
    };
    const auto implicit_one = [&](int stages) {
        std::unique_ptr<ReducedCoordinates> coordinates;
        if (other_) {
            coordinates = std::make_unique<FreeCoordinates>(*other_);
        } else {
            coordinates = std::make_unique<IndependentCoordinates>(scene_, *block_);
        }
        return std::make_unique<RadauIntegrator>(
            integrated(), std::move(coordinates), stages, options, t, std::move(start));
    };
    switch (settings_.method) {
        case Method::euler: return explicit_one(explicit_euler());
        case Method::rk4: return explicit_one(runge_kutta_4());
        case Method::explicit_5: return explicit_one(dormand_prince_54());
        case Method::explicit_8: return explicit_one(dormand_prince_853());
        case Method::semi_implicit:
            return std::make_unique<SemiImplicitEuler>(*block_, options, t, std::move(start));
        case Method::implicit_5: return implicit_one(3);
        case Method::implicit_9: break;
    }
    return implicit_one(5);
}

Baumgarte Simulation::stabilisation() const {
    if (settings_.treatment != Treatment::baumgarte) { return {}; }
    return {settings_.baumgarte, settings_.baumgarte};
}

/// Pure damping does not depend on the angle: it needs no turns.
bool Simulation::counts_turns() const { return depends_on_turns(scene_.loads); }

void Simulation::count_turns_at(const std::vector<double>& y) {
    if (!counts_turns()) { return; }
    count_turns(scene_.loads, kinematics_of(unpacked(y).first));
}

/// Tolerance of samples between steps. Fixed steps end on the constraints to rounding, but set no tolerance
/// for what lies between; there the typed precision of lengths, seven digits, applies.
double Simulation::tolerance_of_samples() const {
    if (drifts(settings_.treatment)) { return std::numeric_limits<double>::infinity(); }
    return entry_of(settings_.method).adaptive ? settings_.tolerance : kRepeatsUpTo;
}

std::optional<SimulationFailure> Simulation::failure_of_step(
    TimeStepper& integration, double event, double end) {
    using Cause = SimulationFailure::Cause;
    const bool went_on = integration.step(event);
    if (!std::ranges::all_of(integration.y(), [](double x) { return std::isfinite(x); })) {
        return SimulationFailure{Cause::not_finite, integration.t(), {}, 0.0};
    }
    if (!went_on) { return failure_of(integration); }
    if (counts_turns()) {
        const std::vector<double> flat = flat_of(integration.y());
        count_turns_at(flat);
        if (const auto lost = failure_of_turns(integration.t(), flat)) { return lost; }
    }
    if (integration.t() < end && integration.counts().steps >= settings_.most_steps) {
        return too_many_steps(integration);
    }
    return std::nullopt;
}

void Simulation::follow_angles_to(const TimeStepper& stepper) {
    if (!angles_) { return; }
    std::vector<ProbedBody> found(moving_.size());
    integrated().motion_of_bodies(stepper.t(), stepper.y().data(), stepper.y_dot().data(), found);
    const auto [state, motion] = unpacked(flat_of(stepper.y()));
    Motion acceleration = zero_motion(scene_.mechanism);
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        acceleration.omega_local[at(moving_[m])] = found[m].A.transpose() * found[m].alpha;
    }
    if (stepper.t() == 0.0) {
        angles_->begin(stepper.t(), state, motion, acceleration);
    } else {
        angles_->reach(stepper.t(), state, motion, acceleration);
    }
}

bool Simulation::may_leave_joints() const {
    return other_ && !settings_.dense && settings_.formulation == Formulation::automatic;
}

std::pair<State, Motion> Simulation::unpacked(const std::vector<double>& y) const {
    return jw::unpacked(scene_.mechanism, moving_, y.data());
}

Energy Simulation::energy(const std::vector<double>& y) const {
    const auto [state, motion] = unpacked(y);
    return energy_of(scene_, state, motion);
}

Snapshot Simulation::snapshot(double t, const std::vector<double>& y) const {
    Snapshot snapshot;
    snapshot.t = t;
    auto [state, motion] = unpacked(y);
    for (const int body : moving_) {
        snapshot.p_drift = std::max(snapshot.p_drift, std::abs(state.p[at(body)].norm() - 1.0));
    }
    const Energy now = energy_of(scene_, state, motion);
    snapshot.kinetic = now.kinetic;
    snapshot.potential = now.potential;
    std::tie(snapshot.position_violation, snapshot.velocity_violation) = block_->violation(t, y.data());
    if (angles_) { snapshot.turns = angles_->turns_at(t, state); }
    snapshot.state = scene_.as_given(state);
    snapshot.velocity = scene_.as_given(state, motion);
    return snapshot;
}

Vec3 Simulation::point(const std::vector<double>& y, int body, const Vec3& point_local) const {
    const int order = order_of_body_[at(body)];
    const Body& fixed = scene_.mechanism.bodies[at(body)];
    if (order < 0) { return fixed.r + rotation_matrix(fixed.p) * point_local; }
    const double* numbers = body_numbers(y.data(), at(order));
    return vec3(numbers) +
           rotation_matrix(vec4(numbers + 3).normalized()) * (point_local - scene_.centres[at(body)]);
}

Vec3 Simulation::point_velocity(const std::vector<double>& y, int body, const Vec3& point_local) const {
    const int order = order_of_body_[at(body)];
    if (order < 0) { return Vec3::Zero(); }
    const double* numbers = body_numbers(y.data(), at(order));
    return vec3(numbers + 7) + rotation_matrix(vec4(numbers + 3).normalized()) *
                                   vec3(numbers + 10).cross(point_local - scene_.centres[at(body)]);
}

/// Takes up rows of the block equations that were left out at a singular start but are needed at a state
/// found with other equations.
void Simulation::take_up_rows(double t, const std::vector<double>& y, std::vector<double>& y_dot) {
    if (!other_ || block_->rows_left_out() == 0) { return; }
    if (!certificate_) { certificate_ = std::make_unique<Certificate>(scene_, stabilisation()); }
    // choosing rows costs as much as a hundred evaluations
    if (is_proven(t, y, y_dot) || !raise_rank(*block_, t, y.data())) { return; }
    block_->evaluate(t, y.data(), y_dot.data());
}

Simulation::~Simulation() = default;

Motion Simulation::acceleration(double t, const std::vector<double>& y) {
    std::vector<double> y_dot(y.size());
    block_->evaluate(t, y.data(), y_dot.data());
    take_up_rows(t, y, y_dot);
    Motion out = zero_motion(scene_.mechanism);
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        out.r_dot[at(moving_[m])] = vec3(body_numbers(y_dot.data(), m) + 7);
        out.omega_local[at(moving_[m])] = vec3(body_numbers(y_dot.data(), m) + 10);
    }
    if (out.theta_dot.empty()) { return out; }
    const auto [state, motion] = unpacked(y);
    std::size_t theta = 0;
    for (const Joint& joint : scene_.mechanism.joints) {
        if (joint.type->artificial == 0) { continue; }
        out.theta_dot[theta] = artificial_acceleration(joint, state, motion, out, state.theta[theta]);
        ++theta;
    }
    return out;
}

Motion Simulation::acceleration_as_given(double t, const std::vector<double>& y) {
    return acceleration_as_given(y, acceleration(t, y));
}

Motion Simulation::acceleration_as_given(const std::vector<double>& y, const Motion& centroidal) const {
    const auto [state, motion] = unpacked(y);
    return scene_.acceleration_as_given(state, motion, centroidal);
}

}  // namespace jw
