#include <algorithm>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "core/integrate/simulation.hpp"
#include "core/motion/forces.hpp"
#include "core/statics/equilibrium.hpp"
#include "tests/support/scene_builder.hpp"

namespace jw {

namespace {

constexpr double kMass = 2.0;
constexpr double kInertia = 0.3;
constexpr double kTolerance = 1e-9;

struct Scene {
    Mechanism mechanism;
    Loads loads;
};

/// A sled on a slide along x, with friction, pulled by a force along x.
Scene sled(double speed, DryFriction friction, double pull) {
    test::SceneBuilder builder;
    const int body = builder.add_body("sled", Vec3(0.3, 0.2, 0.1));
    builder.add_joint("prismatic", 0, body, Vec3(0.3, 0.2, 0.1), Vec3::UnitX());
    builder.mechanism.bodies[1].r_dot = speed * Vec3::UnitX();
    Scene out{builder.mechanism, {}};
    out.loads.masses = {std::nullopt, MassProperties{kMass, Vec3::Zero(), Mat3::Identity()}};
    const DisplacementMeasure along = displacement_of(out.mechanism.joints[0]);
    Spring brake{0, body, along.B_i_local, along.B_j_local};
    brake.s_i_local = along.s_i_local;
    brake.friction = friction;
    out.loads.springs.push_back(brake);
    out.loads.forces.push_back(
        {body, Vec3::Zero(), Vec3::UnitX(), Frame::global, TimeFunction{.polynomial = {pull}}});
    return out;
}

/// A wheel on a hinge about z, with friction, turned by a torque.
Scene wheel(double rate, DryFriction friction, double torque) {
    test::SceneBuilder builder;
    const int body = builder.add_body("wheel", Vec3::Zero());
    builder.add_joint("revolute", 0, body, Vec3::Zero(), Vec3::UnitZ());
    builder.mechanism.bodies[1].omega_local = builder.local(body, rate * Vec3::UnitZ());
    Scene out{builder.mechanism, {}};
    out.loads.masses = {std::nullopt, MassProperties{kMass, Vec3::Zero(), kInertia * Mat3::Identity()}};
    RotationalSpring brake{0, body, angle_of(out.mechanism.joints[0])};
    brake.friction = friction;
    out.loads.rotational_springs.push_back(brake);
    out.loads.torques.push_back({body, Vec3::UnitZ(), Frame::global, TimeFunction{.polynomial = {torque}}});
    return out;
}

/// Rate of the only freedom at `end` [m/s or rad/s].
double rate_at(const Scene& scene, double end, Method method) {
    SimulationSettings settings;
    settings.method = method;
    settings.tolerance = kTolerance;
    settings.step = 1e-4;
    Simulation simulation(scene.mechanism, scene.loads, settings);
    double rate = 0.0;
    const SimulationOutcome outcome = simulation.run({0.0, end}, [&](double t, const std::vector<double>& y) {
        const Snapshot now = simulation.snapshot(t, y);
        rate = scene.loads.springs.empty() ? now.velocity.omega_local[1].norm() : now.velocity.r_dot[1].x();
    });
    REQUIRE_FALSE(outcome.failure);
    return rate;
}

/// First integral of m v' = -F v / √(v² + s²): this plus F t / m is constant.
double way_left(double v, double s) { return std::hypot(v, s) - s * std::asinh(s / v); }

}  // namespace

TEST_CASE(
    "Dry friction stops a sled and a wheel as its closed form says, by all methods", "[core][dynamics]") {
    const DryFriction friction{1.5, 0.02};
    const double end = 0.9;
    for (const MethodName& method : kMethods) {
        CAPTURE(method.name);
        // with fixed steps h = 1e-4 the simplest method has an error of h in the rate, and in way_left
        const double allowed = entry_of(method.method).adaptive ? 1e-6 : 1e-3;
        for (const bool slides : {true, false}) {
            const Scene scene = slides ? sled(0.7, friction, 0.0) : wheel(4.51, friction, 0.0);
            const double inertia = slides ? kMass : kInertia;
            const double v = rate_at(scene, end, method.method);
            CHECK(v > 0.0);
            const double before = way_left(slides ? 0.7 : 4.51, friction.speed);
            CHECK(std::abs(way_left(v, friction.speed) + friction.size * end / inertia - before) < allowed);
        }
    }
}

TEST_CASE(
    "What is pulled by less than its friction creeps at the speed that the friction tells",
    "[core][dynamics]") {
    for (const double share : {0.1, 0.5, 0.9, 0.99}) {
        const DryFriction friction{2.0, 1e-3};
        const double creeps = friction.speed * share / std::sqrt(1.0 - share * share);
        const double pull = share * friction.size;
        CAPTURE(share, creeps);
        // the slowest of these reaches its rate within (1 - share²)^(-3/2) m s / F = 0.4 s
        for (const Method method : {Method::explicit_8, Method::implicit_9}) {
            CHECK(rate_at(sled(0.0, friction, pull), 10.0, method) == Approx(creeps).epsilon(1e-6));
            CHECK(rate_at(wheel(0.0, friction, pull), 10.0, method) == Approx(creeps).epsilon(1e-6));
        }
    }
    // a larger pull accelerates the sled by the difference
    const double sped_up = rate_at(sled(0.0, {2.0, 1e-3}, 3.0), 4.0, Method::explicit_8);
    CHECK(sped_up == Approx((3.0 - 2.0) / kMass * 4.0).epsilon(1e-3));
}

TEST_CASE("A law of a spring keeps the energy that its closed form stores", "[core][dynamics]") {
    using Kind = FormulaStep::Kind;
    // f = 5 x + 40 x³ + 3 |x|, whose potential is 5 x² / 2 + 10 x⁴ + 3 x |x| / 2
    const ScalarFormula law{
        "",
        {{Kind::number, 5.0},
         {Kind::variable, 0.0},
         {Kind::product},
         {Kind::number, 40.0},
         {Kind::variable, 0.0},
         {Kind::power, 3.0},
         {Kind::product},
         {Kind::sum},
         {Kind::number, 3.0},
         {Kind::variable, 0.0},
         {Kind::absolute},
         {Kind::product},
         {Kind::sum}}};
    for (const bool slides : {true, false}) {
        Scene scene = slides ? sled(0.7, {}, 0.0) : wheel(0.7, {}, 0.0);
        const double inertia = slides ? kMass : kInertia;
        if (slides) { scene.loads.springs[0].law = law; }
        if (!slides) { scene.loads.rotational_springs[0].law = law; }
        SimulationSettings settings;
        settings.tolerance = kTolerance;
        Simulation simulation(scene.mechanism, scene.loads, settings);
        double moved = 0.0;
        const auto outcome =
            simulation.run({0.0, 0.1, 0.37, 1.0, 5.0}, [&](double t, const std::vector<double>& y) {
                const Snapshot now = simulation.snapshot(t, y);
                const double x =
                    slides ? now.state.r[1].x() - 0.3 : relative_angle(scene.mechanism.joints[0], now.state);
                const double v = slides ? now.velocity.r_dot[1].x() : now.velocity.omega_local[1].norm();
                const double stored = 2.5 * x * x + 10.0 * x * x * x * x + 1.5 * x * std::abs(x);
                CHECK(now.potential == Approx(stored).epsilon(1e-10).margin(1e-14));
                CHECK(0.5 * inertia * v * v + stored == Approx(0.5 * inertia * 0.49).epsilon(1e-7));
                moved = std::max(moved, std::abs(x));
            });
        CHECK_FALSE(outcome.failure);
        CHECK(moved > 0.05);
    }
}

TEST_CASE(
    "A narrow pulse of a formula gives its impulse, by all methods that choose their steps",
    "[core][dynamics]") {
    using Kind = FormulaStep::Kind;
    // 300 exp(-((t - 5) / 0.002)²) N, whose integral is 300 (0.002) sqrt(π) N s
    const double width = 0.002;
    TimeFunction pulse;
    pulse.formula = TimeFormula{
        {"",
         {{Kind::number, 300.0},
          {Kind::variable},
          {Kind::number, 5.0},
          {Kind::difference},
          {Kind::number, width},
          {Kind::quotient},
          {Kind::power, 2.0},
          {Kind::negative},
          {Kind::exponential},
          {Kind::product}}},
        1.0};
    for (const MethodName& method : kMethods) {
        if (!method.adaptive) { continue; }
        CAPTURE(method.name);
        Scene scene = sled(0.0, {}, 0.0);
        scene.loads.forces[0].magnitude = pulse;
        const double expected = 300.0 * width * std::sqrt(std::numbers::pi) / kMass;
        CHECK(rate_at(scene, 10.0, method.method) == Approx(expected).epsilon(1e-6));
    }
}

TEST_CASE(
    "A sled comes to rest where its law is zero, and swings about it by the slope there", "[core][statics]") {
    using Kind = FormulaStep::Kind;
    const auto rest_of = [](std::vector<FormulaStep> law, double pull) {
        Scene scene = sled(0.0, {}, pull);
        scene.loads.springs[0].law = ScalarFormula{"", std::move(law)};
        const Centroidal centred = centroidal(scene.mechanism, scene.loads);
        return find_equilibrium(centred, start_state(centred.mechanism), 0.0, Seek::where_it_rests);
    };
    const auto place = [](const RestOutcome& rest) { return rest.state.r[1].x() - 0.3; };
    const auto omega = [](const RestOutcome& rest) { return rest.motions.modes.at(0).s; };
    const std::vector<FormulaStep> linear{
        {Kind::number, 20.0},
        {Kind::variable, 0.0},
        {Kind::product},
        {Kind::number, 3.0},
        {Kind::difference}};
    RestOutcome rest = rest_of(linear, 0.0);
    CHECK(rest.failure == RestOutcome::Failure::none);
    CHECK(place(rest) == Approx(0.15));
    CHECK(rest.motions.stability == Stability::stable);
    CHECK(omega(rest).imag() == Approx(std::sqrt(20.0 / kMass)));
    // sin(10⁴ d): a slope that a difference over a millimetre does not see
    rest = rest_of({{Kind::number, 1e4}, {Kind::variable, 0.0}, {Kind::product}, {Kind::sine}}, 0.0);
    CHECK(rest.motions.stability == Stability::stable);
    CHECK(omega(rest).imag() == Approx(std::sqrt(1e4 / kMass)));
    // 20 d - 0.1 ḋ: a law that adds energy to the motion, with a potential that has its minimum there
    rest = rest_of(
        {{Kind::number, 20.0},
         {Kind::variable, 0.0},
         {Kind::product},
         {Kind::number, 0.1},
         {Kind::variable, 1.0},
         {Kind::product},
         {Kind::difference}},
        0.0);
    CHECK(rest.motions.stability == Stability::unstable);
    CHECK(omega(rest).real() == Approx(0.1 / (2.0 * kMass)));
    // 400 (d - |d|), exactly at its kink; pushed into it, it is a spring of 800 N/m
    const std::vector<FormulaStep> bumper{{Kind::number, 400.0}, {Kind::variable, 0.0}, {Kind::variable, 0.0},
                                          {Kind::absolute},      {Kind::difference},    {Kind::product}};
    CHECK(rest_of(bumper, 0.0).motions.at_kink);
    CHECK(rest_of(bumper, 0.0).motions.stability == Stability::cannot_tell);
    rest = rest_of(bumper, -2.0);
    CHECK(place(rest) == Approx(-2.0 / 800.0));
    CHECK(omega(rest).imag() == Approx(std::sqrt(800.0 / kMass)));
}

TEST_CASE(
    "Friction does no work at rest and takes its size times the speed beyond", "[core][dynamics][forces]") {
    const DryFriction friction{3.0, 0.01};
    CHECK(friction.at(0.0) == 0.0);
    CHECK(friction.at(10.0) == Approx(3.0).epsilon(1e-6));
    CHECK(friction.at(-10.0) == Approx(-3.0).epsilon(1e-6));
    CHECK(friction.at(0.01) == Approx(3.0 / std::sqrt(2.0)));
    CHECK(without_friction(sled(0.0, friction, 1.0).loads).springs[0].friction == DryFriction{});
    CHECK(without_friction(wheel(0.0, friction, 1.0).loads).rotational_springs[0].friction == DryFriction{});
}

TEST_CASE(
    "Between steps, samples are as exact as at their ends where friction changes fast", "[core][dynamics]") {
    Scene scene = wheel(3.0, {1.4, 0.01}, 0.0);
    scene.loads.rotational_springs[0].stiffness = 8.4;
    std::vector<double> times;
    for (int k = 0; k <= 200; ++k) { times.push_back(0.01 * k); }
    const auto samples = [&](double tolerance) {
        SimulationSettings settings;
        settings.tolerance = tolerance;
        Simulation simulation(scene.mechanism, scene.loads, settings);
        std::vector<Vec4> out;
        const SimulationOutcome outcome = simulation.run(times, [&](double t, const std::vector<double>& y) {
            out.push_back(simulation.snapshot(t, y).state.p[1]);
        });
        REQUIRE_FALSE(outcome.failure);
        return out;
    };
    const std::vector<Vec4> exact = samples(1e-11);
    const std::vector<Vec4> coarse = samples(1e-6);
    REQUIRE(coarse.size() == times.size());
    double most = 0.0;
    for (std::size_t k = 0; k < coarse.size(); ++k) {
        most = std::max(most, std::min((coarse[k] - exact[k]).norm(), (coarse[k] + exact[k]).norm()));
    }
    CHECK(most < 1e-5);
}

}  // namespace jw
