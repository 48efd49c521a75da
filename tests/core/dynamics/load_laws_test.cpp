#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <numbers>

#include "core/integrate/simulation.hpp"
#include "core/jets/body_kinematics.hpp"
#include "core/motion/forces.hpp"
#include "core/motion/spring_turns.hpp"
#include "tests/core/dynamics/statics.hpp"

namespace jw {

namespace {

using StepKind = FormulaStep::Kind;

/// constant + Σ factor x_k
ScalarFormula weighted(double constant, const std::vector<double>& factors) {
    ScalarFormula out{"linear", {{StepKind::number, constant}}};
    for (std::size_t k = 0; k < factors.size(); ++k) {
        if (factors[k] == 0.0) { continue; }
        const std::vector<FormulaStep> term{
            {StepKind::number, factors[k]},
            {StepKind::variable, static_cast<double>(k)},
            {StepKind::product},
            {StepKind::sum}};
        out.steps.insert(out.steps.end(), term.begin(), term.end());
    }
    return out;
}

LoadLaw::Quantity angle_read(const Joint& joint) {
    RotationalSpring angle{joint.body_i, joint.body_j, angle_of(joint)};
    angle.is_read = true;
    return {joint.name + ".angle", angle};
}

Spring along_slide(const Joint& joint) {
    const DisplacementMeasure along = displacement_of(joint);
    Spring out{joint.body_i, joint.body_j, along.B_i_local, along.B_j_local};
    out.s_i_local = along.s_i_local;
    return out;
}

struct LawScene {
    Mechanism mechanism;
    Loads loads;
};

constexpr double kInertiaOfWheel = 0.3;
constexpr double kMassOfSled = 2.0;

/// A wheel on a hinge about z, whose motor follows a law of t, the angle and its rate.
LawScene wheel_with(double rate, const ScalarFormula& formula) {
    test::SceneBuilder builder;
    const int body = builder.add_body("wheel", Vec3::Zero());
    builder.add_joint("revolute", 0, body, Vec3::Zero(), Vec3::UnitZ());
    builder.mechanism.bodies[1].omega_local = builder.local(body, rate * Vec3::UnitZ());
    LawScene out{builder.mechanism, {}};
    out.loads.masses = {
        std::nullopt, MassProperties{kMassOfSled, Vec3::Zero(), kInertiaOfWheel * Mat3::Identity()}};
    out.loads.torques.push_back({body, Vec3::UnitZ(), Frame::global, {}});
    out.loads.torques[0].law = LoadLaw{formula, {angle_read(out.mechanism.joints[0])}};
    return out;
}

/// A sled at rest on a slide along x.
LawScene sled_at_rest() {
    test::SceneBuilder builder;
    const int body = builder.add_body("sled", Vec3(0.3, 0.2, 0.1));
    builder.add_joint("prismatic", 0, body, Vec3(0.3, 0.2, 0.1), Vec3::UnitX());
    LawScene out{builder.mechanism, {}};
    out.loads.masses = {std::nullopt, MassProperties{kMassOfSled, Vec3::Zero(), Mat3::Identity()}};
    return out;
}

/// States of a run at its end.
Snapshot end_of(
    const LawScene& scene, double end, Method method, Formulation formulation = Formulation::automatic) {
    SimulationSettings settings;
    settings.method = method;
    settings.formulation = method == Method::semi_implicit ? Formulation::bodies : formulation;
    settings.tolerance = 1e-9;
    settings.step = 1e-4;
    Simulation simulation(scene.mechanism, scene.loads, settings);
    Snapshot last;
    const SimulationOutcome outcome = simulation.run(
        {0.0, end}, [&](double t, const std::vector<double>& y) { last = simulation.snapshot(t, y); });
    REQUIRE_FALSE(outcome.failure);
    return last;
}

/// Error of the simplest method with the step above: its step times the size of θ̈ t, and some.
double allowed_error(Method method) { return entry_of(method).adaptive ? 1e-6 : 1e-2; }

/// Distance of two angles, without whole turns.
double apart(double a, double b) { return std::abs(std::remainder(a - b, 2.0 * std::numbers::pi)); }

/// Variables of a law: t, an angle with its rate, a distance and a displacement with theirs.
constexpr std::size_t kVariables = 7;

/// Two bodies at known places, and what a law measures between them.
struct Measured2 {
    std::vector<BodyKinematics<OmegaLocal>> bodies;
    LoadLaw law;
    std::array<double, kVariables> expected{1.7, 0.4, 0.6, 2.5, 0.5 * 0.8, 2.0, 0.5};

    Measured2() {
        // turned by 0.4 rad about z, turning and moving along x
        const Vec4 p(std::cos(0.2), 0.0, 0.0, std::sin(0.2));
        bodies.push_back(kinematics_at<OmegaLocal>(Vec3::Zero(), Vec4::Unit(0), Vec3::Zero(), Vec3::Zero()));
        bodies.push_back(
            kinematics_at<OmegaLocal>(Vec3(2.0, 1.5, 0.0), p, 0.5 * Vec3::UnitX(), 0.6 * Vec3::UnitZ()));
        Spring distance{0, 1, Vec3::Zero(), Vec3::Zero()};
        Spring displacement = distance;
        displacement.s_i_local = Vec3::UnitX();
        law.formula = weighted(0.3, {0.1, 2.0, 3.0, 5.0, 7.0, 11.0, 13.0});
        law.quantities = {
            {"a", RotationalSpring{0, 1, {Vec3::UnitZ(), Vec3::UnitX(), Vec3::UnitX()}}},
            {"b", distance},
            {"c", displacement}};
    }
    Loads loads() const {
        Loads out;
        out.masses.resize(2);
        out.forces.push_back({1, Vec3(0.0, 0.5, 0.0), Vec3(0.0, 0.0, 2.0), Frame::global, {}, law});
        out.torques.push_back({1, Vec3(0.0, 3.0, 0.0), Frame::local, {.polynomial = {4.0}}, 0, law});
        return out;
    }
    double value() const { return law.formula.at(expected); }
};

}  // namespace

TEST_CASE("A law reads time, angles, lengths and their rates", "[core][dynamics][forces]") {
    const Measured2 scene;
    const double value = 0.3 + 0.17 + 0.8 + 1.8 + 12.5 + 2.8 + 22.0 + 6.5;
    CHECK(scene.value() == Approx(value));
    CHECK(value_of(scene.law, scene.bodies, 1.7) == Approx(value));
    std::vector<BodyForce> forces(2);
    add_forces(scene.loads(), scene.bodies, 1.7, forces);
    CHECK(forces[1].f.z() == Approx(2.0 * value));
    CHECK(forces[0].f.norm() == 0.0);
    // the arm of the force is 0.5 m along y of the body
    CHECK(forces[1].n_local.x() == Approx(0.5 * 2.0 * value));
    CHECK(forces[1].n_local.y() == Approx(3.0 * (4.0 + value)));
    // against, in the frame of the ground
    CHECK(forces[0].n_local.y() == Approx(-3.0 * (4.0 + value) * std::cos(0.4)));
    CHECK(forces[0].n_local.x() == Approx(3.0 * (4.0 + value) * std::sin(0.4)));
    CHECK(size_of(scene.law, scene.bodies, 1.7) == Approx(value));
}

TEST_CASE(
    "Laws at rest have their slopes, and in time they are functions of it", "[core][dynamics][forces]") {
    Measured2 scene;
    scene.bodies[1] = kinematics_at<OmegaLocal>(
        scene.bodies[1].r, Vec4(std::cos(0.2), 0.0, 0.0, std::sin(0.2)), Vec3::Zero(), Vec3::Zero());
    // 2 θ² + 3 θ̇ + d sin t
    scene.law.formula.steps = {
        {StepKind::number, 2.0},
        {StepKind::variable, 1.0},
        {StepKind::power, 2.0},
        {StepKind::product},
        {StepKind::number, 3.0},
        {StepKind::variable, 2.0},
        {StepKind::product},
        {StepKind::sum},
        {StepKind::variable, 5.0},
        {StepKind::variable, 0.0},
        {StepKind::sine},
        {StepKind::product},
        {StepKind::sum}};
    Loads loads = scene.loads();
    const std::vector<ScalarFormula> in_time = laws_in_time(loads, scene.bodies);
    REQUIRE(in_time.size() == 2);
    CHECK(in_time[0].at(std::array{0.9}) == Approx(2.0 * 0.16 + 2.0 * std::sin(0.9)));

    CHECK(unbounded_law(loads, scene.bodies, 1.7, 1, 1e-4).empty());
    CHECK(linearise_laws(loads, scene.bodies, 1.7));
    const auto straight = [](double angle, double rate, double d) {
        return 2.0 * 0.16 + 4.0 * 0.4 * (angle - 0.4) + 3.0 * rate + d * std::sin(1.7);
    };
    const ScalarFormula& law = loads.forces[0].law->formula;
    CHECK(law.at(std::array{5.0, 0.7, 0.2, 0.0, 0.0, 2.3, 0.0}) == Approx(straight(0.7, 0.2, 2.3)));
    // a kink in a rate at rest
    loads.torques[0].law->formula = {"kink", {{StepKind::variable, 2.0}, {StepKind::absolute}}};
    CHECK(unbounded_law(loads, scene.bodies, 1.7, 1, 1e-4) == "kink");
    CHECK_FALSE(linearise_laws(loads, scene.bodies, 1.7));
    // it has a value, unlike its reciprocal, also beside 0 as far as asked for
    const auto has_no_value = [&](double of, double beside) {
        loads.torques[0].law->formula = {
            "pole",
            {{StepKind::number, 1.0},
             {StepKind::variable, 2.0},
             {StepKind::number, of},
             {StepKind::difference},
             {StepKind::quotient}}};
        return unbounded_law(loads, scene.bodies, 1.7, 0, beside) == "pole";
    };
    CHECK(unbounded_law(loads, scene.bodies, 1.7, 0, 1e-4).empty());
    CHECK(has_no_value(0.0, 1e-9));
    CHECK(has_no_value(1e-6, 1.1e-6));
    CHECK_FALSE(has_no_value(1e-6, 0.9e-6));
}

TEST_CASE("What a law reads does not depend on where the frames of bodies lie", "[core][dynamics][forces]") {
    for (unsigned seed = 1; seed <= 10; ++seed) {
        CAPTURE(seed);
        test::Random random(seed);
        const test::Pair pair = test::random_pair(seed);
        Loads loads = test::without_loads(pair.mechanism, seed);
        Spring distance{0, 1, random.vector(), random.vector()};
        Spring displacement{0, 1, random.vector(), random.vector()};
        displacement.s_i_local = random.direction();
        const LoadLaw law{
            weighted(0.2, {0.3, 1.0, 2.0, -0.7, 1.3}),
            {{"distance", distance}, {"displacement", displacement}}};
        loads.forces.push_back({1, Vec3::Zero(), Vec3::UnitX(), Frame::global, {}, law});
        const Centroidal scene = centroidal(pair.mechanism, loads);
        const auto& [state, motion] = pair.moment;
        const double as_given = value_of(law, kinematics_of(state, motion), 0.7);
        const double moved = value_of(
            *scene.loads.forces[0].law,
            kinematics_of(scene.to_centroidal(state), scene.to_centroidal(state, motion)), 0.7);
        CHECK(std::abs(moved - as_given) < 1e-13 * (1.0 + std::abs(as_given)));  // rounding
    }
}

TEST_CASE("A controlled wheel swings as its closed form, by all methods", "[core][dynamics]") {
    // J θ̈ = -k (θ - 0.5) - c θ̇
    const LawScene scene = wheel_with(2.0, weighted(2.4, {0.0, -4.8, -0.6}));
    const double end = 0.9;
    const double delta = 0.6 / (2.0 * kInertiaOfWheel);
    const double omega = std::sqrt(4.8 / kInertiaOfWheel - delta * delta);
    const double sine = (2.0 - 0.5 * delta) / omega;
    const double expected =
        0.5 + std::exp(-delta * end) * (sine * std::sin(omega * end) - 0.5 * std::cos(omega * end));
    for (const MethodName& method : kMethods) {
        CAPTURE(method.name);
        for (const Formulation formulation : {Formulation::automatic, Formulation::bodies}) {
            const Snapshot last = end_of(scene, end, method.method, formulation);
            const double angle = relative_angle(scene.mechanism.joints[0], last.state);
            CHECK(apart(angle, expected) < allowed_error(method.method));
            CHECK(last.potential == 0.0);
        }
    }
}

TEST_CASE("A law counts the turns of its angle", "[core][dynamics]") {
    // J θ̈ = -k θ with an amplitude of 2.4 turns
    const double omega = 2.0;
    const LawScene scene = wheel_with(30.0, weighted(0.0, {0.0, -omega * omega * kInertiaOfWheel}));
    CHECK(depends_on_turns(scene.loads));
    LawScene only_rate = scene;
    std::get<RotationalSpring>(only_rate.loads.torques[0].law->quantities[0].measured).is_read = false;
    CHECK_FALSE(depends_on_turns(only_rate.loads));
    for (const Method method : {Method::rk4, Method::explicit_8, Method::implicit_9}) {
        for (const double end : {0.4, 1.3}) {
            const Snapshot last = end_of(scene, end, method);
            const double expected = 30.0 / omega * std::sin(omega * end);
            CHECK(apart(relative_angle(scene.mechanism.joints[0], last.state), expected) < 1e-5);
        }
    }
    // poses of a motion several turns apart
    const auto centres = std::make_shared<const Centroidal>(centroidal(scene.mechanism, scene.loads));
    const State start = start_state(centres->mechanism);
    const auto there = SpringTurns(centres, start, {0}).at(start, {3});
    const auto rest = kinematics_of(start);
    const double pull = value_of(*centres->loads.torques[0].law, rest, 0.0);
    CHECK(
        value_of(*there->loads.torques[0].law, rest, 0.0) - pull ==
        Approx(-omega * omega * kInertiaOfWheel * 6.0 * std::numbers::pi));
}

TEST_CASE("Laws with the time follow their closed form, as of a spring and of a force", "[core][dynamics]") {
    // m ẍ = 3 t - 20 x from rest
    const double omega = std::sqrt(20.0 / kMassOfSled);
    const double end = 1.1;
    const double expected = 0.15 * (end - std::sin(omega * end) / omega);
    LawScene by_force = sled_at_rest();
    const Joint& slide = by_force.mechanism.joints[0];
    by_force.loads.forces.push_back({1, Vec3::Zero(), Vec3::UnitX(), Frame::global, {}});
    by_force.loads.forces[0].law =
        LoadLaw{weighted(0.0, {3.0, -20.0}), {{"slide.displacement", along_slide(slide)}}};
    LawScene by_spring = sled_at_rest();
    by_spring.loads.springs = {along_slide(slide)};
    by_spring.loads.springs[0].law = weighted(0.0, {20.0, 0.0, -3.0});
    for (const MethodName& method : kMethods) {
        CAPTURE(method.name);
        for (const LawScene* scene : {&by_force, &by_spring}) {
            const Snapshot last = end_of(*scene, end, method.method);
            CHECK(std::abs(last.state.r[1].x() - 0.3 - expected) < allowed_error(method.method));
            CHECK(last.potential == 0.0);
        }
    }
    const auto& spring = by_spring.loads.springs[0];
    const auto bodies = kinematics_of(start_state(by_spring.mechanism));
    CHECK(size_of(spring, bodies, 2.0) == Approx(6.0));

    // J θ̈ = 0.9 t - 4.8 θ
    LawScene turned = wheel_with(0.0, weighted(0.0, {}));
    RotationalSpring about{0, 1, angle_of(turned.mechanism.joints[0])};
    about.law = weighted(0.0, {4.8, 0.0, -0.9});
    CHECK(size_of(about, 2.0) == Approx(1.8));
    turned.loads.torques.clear();
    turned.loads.rotational_springs = {about};
    const Snapshot last = end_of(turned, end, Method::explicit_8);
    const double turn = 0.9 / 4.8 * (end - std::sin(4.0 * end) / 4.0);
    CHECK(apart(relative_angle(turned.mechanism.joints[0], last.state), turn) < 1e-6);
    CHECK(last.potential == 0.0);
}

TEST_CASE("A torque between two bodies by a law is the same as a rotational spring", "[core][dynamics]") {
    LawScene by_spring{test::row_of_rods({0.3, 1.1}).mechanism, {}};
    by_spring.loads = test::point_masses(by_spring.mechanism, 1.0, 0.1);
    LawScene by_law = by_spring;
    const Joint& elbow = by_spring.mechanism.joints[1];
    by_spring.loads.rotational_springs.push_back(
        {elbow.body_i, elbow.body_j, angle_of(elbow), 7.0, 0.2, 0.4});
    by_law.loads.torques.push_back({elbow.body_j, Vec3::UnitY(), Frame::global, {}, elbow.body_i});
    by_law.loads.torques[0].law = LoadLaw{weighted(7.0 * 0.2, {0.0, -7.0, -0.4}), {angle_read(elbow)}};
    for (const Formulation formulation : {Formulation::bodies, Formulation::joints}) {
        const Snapshot spring = end_of(by_spring, 1.0, Method::explicit_8, formulation);
        const Snapshot law = end_of(by_law, 1.0, Method::explicit_8, formulation);
        for (const std::size_t b : {1U, 2U}) {
            CHECK((spring.state.r[b] - law.state.r[b]).norm() < 1e-7);  // two runs at 1e-9
        }
    }
}

TEST_CASE("A run that ends where a law has no value names the law", "[core][dynamics]") {
    // 3 + √(0.2 - θ)
    const LawScene scene = wheel_with(
        0.0, {"root",
              {{StepKind::number, 3.0},
               {StepKind::number, 0.2},
               {StepKind::variable, 1.0},
               {StepKind::difference},
               {StepKind::square_root},
               {StepKind::sum}}});
    SimulationSettings settings;
    settings.most_steps = 3000;
    Simulation simulation(scene.mechanism, scene.loads, settings);
    const SimulationOutcome outcome = simulation.run({0.0, 1.0}, [](double, const std::vector<double>&) {});
    REQUIRE(outcome.failure);
    CHECK(outcome.failure->law == "root");
}

TEST_CASE("Steps end between the swings of a law in time", "[core][dynamics]") {
    LawScene scene = wheel_with(0.0, weighted(0.0, {0.0, -4.8}));
    CHECK(events_until(10.0, centroidal(scene.mechanism, scene.loads)).size() == 1);
    // -4.8 θ + sin 20 t
    auto& steps = scene.loads.torques[0].law->formula.steps;
    const std::vector<FormulaStep> swing{
        {StepKind::number, 20.0},
        {StepKind::variable, 0.0},
        {StepKind::product},
        {StepKind::sine},
        {StepKind::sum}};
    steps.insert(steps.end(), swing.begin(), swing.end());
    const auto events = events_until(10.0, centroidal(scene.mechanism, scene.loads));
    CHECK(static_cast<double>(events.size()) >= 10.0 * 20.0 / std::numbers::pi);
    // a kink in time has no bound: it is left to the error of the steps
    steps.push_back({StepKind::absolute});
    CHECK(events_until(10.0, centroidal(scene.mechanism, scene.loads)).size() == 1);
}

}  // namespace jw
