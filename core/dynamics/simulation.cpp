#include "core/dynamics/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/dynamics/dense_equations.hpp"
#include "core/dynamics/explicit_integrator.hpp"
#include "core/dynamics/radau.hpp"
#include "core/dynamics/semi_implicit.hpp"

namespace jw {

namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

void require(const SimulationSettings& settings) {
    const MethodName& method = entry_of(settings.method);
    const std::string_view unfit = why_not(settings.method, settings.treatment);
    if (!unfit.empty()) { throw std::invalid_argument(std::string(unfit)); }
    if (settings.dense && method.kind != MethodKind::runge_kutta) {
        throw std::invalid_argument("a coordinate choice needs an explicit Runge-Kutta method");
    }
    if (method.adaptive && !(settings.tolerance > 0.0)) {
        throw std::invalid_argument("the tolerance must be positive");
    }
    if (!method.adaptive && !(settings.step > 0.0)) {
        throw std::invalid_argument("the step must be positive");
    }
}

/// Equations left out because they repeat others hold as well as the numbers of a lesson were typed, seven
/// digits at least; where they are off by more they say something else.
constexpr double kRepeatsUpTo = 1e-6;

/// Joint or driver of a row.
std::string name_of(const System& system, int row) {
    const RowOrigin origin = system.origin(row);
    const auto index = at(origin.index);
    const Mechanism& mechanism = system.mechanism();
    if (origin.kind == RowOrigin::Kind::driver) {
        return mechanism.drivers[at(system.drivers()[index].driver)].name;
    }
    return mechanism.joints[at(system.constraints()[index].joint)].name;
}

Baumgarte stabilisation(const SimulationSettings& settings) {
    if (settings.treatment != Treatment::baumgarte) { return {}; }
    return {settings.baumgarte, settings.baumgarte};
}

}  // namespace

Simulation::Simulation(const Mechanism& mechanism, const Loads& loads, const SimulationSettings& settings)
    : scene_(centroidal(mechanism, loads)), settings_(settings) {
    require(settings);
    block_ = block_equations(scene_, stabilisation(settings));
    if (settings.dense) { dense_ = dense_equations(scene_, *settings.dense, stabilisation(settings)); }
    moving_ = moving_bodies_of(mechanism);
    order_of_body_.assign(mechanism.bodies.size(), -1);
    for (std::size_t m = 0; m < moving_.size(); ++m) { order_of_body_[at(moving_[m])] = static_cast<int>(m); }
    start_ = flat_start(scene_.mechanism);
    block_->choose_rows(0.0, start_.data());
    block_->project(0.0, start_.data());
    look_for_contradiction();
}

void Simulation::look_for_contradiction() {
    const double violation = block_->violation(0.0, start_.data()).first;
    if (violation <= kRepeatsUpTo) { return; }
    const System system(scene_.mechanism, everything(scene_.mechanism));
    Assembler<OmegaLocal> assembler(system);
    assembler.assemble_phi_and_jacobian(unpacked(start_).first, 0.0);
    int worst = 0;
    const auto size = [&](int row) { return std::abs(assembler.phi()(row)) / system.row_unit(row); };
    for (int row = 1; row < system.rows(); ++row) {
        if (size(row) > size(worst)) { worst = row; }
    }
    contradiction_ =
        SimulationFailure{SimulationFailure::Cause::contradiction, 0.0, name_of(system, worst), violation};
}

std::unique_ptr<TimeStepper> Simulation::stepper() const {
    IntegrationOptions options;
    options.tolerance = settings_.tolerance;
    options.length_scale = extent(scene_.mechanism);
    options.project =
        settings_.treatment == Treatment::projection || settings_.treatment == Treatment::tangent;
    if (!entry_of(settings_.method).adaptive) { options.fixed_step = settings_.step; }
    const auto explicit_one = [&](const RungeKuttaTable& table) {
        MotionEquations& equations = dense_ ? *dense_ : *block_;
        std::vector<double> y(static_cast<std::size_t>(equations.size()));
        equations.from_flat(start_.data(), y.data());
        return std::make_unique<ExplicitIntegrator>(equations, table, options, 0.0, std::move(y));
    };
    switch (settings_.method) {
        case Method::euler: return explicit_one(explicit_euler());
        case Method::rk4: return explicit_one(runge_kutta_4());
        case Method::explicit_5: return explicit_one(dormand_prince_54());
        case Method::explicit_8: return explicit_one(dormand_prince_853());
        case Method::semi_implicit: return std::make_unique<SemiImplicitEuler>(*block_, options, 0.0, start_);
        case Method::implicit_5:
            return std::make_unique<RadauIntegrator>(scene_, *block_, 3, options, 0.0, start_);
        case Method::implicit_9: break;
    }
    return std::make_unique<RadauIntegrator>(scene_, *block_, 5, options, 0.0, start_);
}

SimulationOutcome Simulation::run(const std::vector<double>& times, const Sampler::Receive& receive) {
    if (contradiction_) { return {{}, contradiction_}; }
    const std::unique_ptr<TimeStepper> integration = stepper();
    Sampler sampler(dense_ ? *dense_ : *block_, times, receive);
    sampler.take(*integration);
    const double end = times.empty() ? 0.0 : times.back();
    SimulationOutcome outcome;
    while (integration->t() < end && !outcome.failure) {
        const bool went_on = integration->step(end);
        const bool finite = std::ranges::all_of(integration->y(), [](double x) { return std::isfinite(x); });
        using Cause = SimulationFailure::Cause;
        if (!finite) {
            outcome.failure = SimulationFailure{Cause::not_finite, integration->t(), {}, 0.0};
        } else if (!went_on) {
            outcome.failure = SimulationFailure{Cause::step_too_small, integration->t(), {}, 0.0};
        } else if (integration->counts().steps >= settings_.most_steps) {
            outcome.failure = SimulationFailure{Cause::too_many_steps, integration->t(), {}, 0.0};
        }
        if (finite) { sampler.take(*integration); }
    }
    sampler.finish();
    outcome.counts = integration->counts();
    return outcome;
}

std::pair<State, Motion> Simulation::unpacked(const std::vector<double>& y) const {
    std::pair<State, Motion> out{start_state(scene_.mechanism), start_motion(scene_.mechanism)};
    State& state = out.first;
    unpack(y.data(), moving_, state, out.second);
    std::size_t theta = 0;
    for (const Joint& joint : scene_.mechanism.joints) {
        if (joint.type->artificial > 0) { state.theta[theta++] = relative_angle(joint, state); }
    }
    return out;
}

Snapshot Simulation::snapshot(double t, const std::vector<double>& y) const {
    Snapshot snapshot;
    snapshot.t = t;
    auto [state, motion] = unpacked(y);
    for (const int body : moving_) {
        snapshot.p_drift = std::max(snapshot.p_drift, std::abs(state.p[at(body)].norm() - 1.0));
    }
    snapshot.kinetic = block_->kinetic_energy(y.data());
    snapshot.potential = block_->potential_energy(y.data());
    std::tie(snapshot.position_violation, snapshot.velocity_violation) = block_->violation(t, y.data());
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

Motion Simulation::acceleration(double t, const std::vector<double>& y) const {
    std::vector<double> y_dot(y.size());
    block_->evaluate(t, y.data(), y_dot.data());
    Motion out = zero_motion(scene_.mechanism);
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        out.r_dot[at(moving_[m])] = vec3(body_numbers(y_dot.data(), m) + 7);
        out.omega_local[at(moving_[m])] = vec3(body_numbers(y_dot.data(), m) + 10);
    }
    return out;
}

Motion Simulation::acceleration_as_given(double t, const std::vector<double>& y) const {
    const auto [state, motion] = unpacked(y);
    return scene_.acceleration_as_given(state, motion, acceleration(t, y));
}

}  // namespace jw
