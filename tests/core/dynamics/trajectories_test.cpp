#include <catch2/catch.hpp>

#include "tests/support/fixed_steps.hpp"
#include "tests/support/random_dynamics.hpp"

using namespace jw;

namespace {

constexpr std::array kChoices{
    CoordinateChoice::omega_local, CoordinateChoice::omega_global, CoordinateChoice::true_euler_parameters,
    CoordinateChoice::modified_euler_parameters};

/// Fixed steps in a coordinate choice, from a moment to a moment.
template <class C>
test::Moment moved_on(
    const Centroidal& scene, test::Moment moment, double duration, int steps, bool project = true,
    const Baumgarte& baumgarte = {}, const RungeKuttaTable& table = dormand_prince_853()) {
    DenseEquations<C> equations(scene, baumgarte);
    std::vector<double> y(static_cast<std::size_t>(equations.size()));
    equations.pack(moment.state, moment.motion, y.data());
    y = test::run(equations, table, y, duration, steps, project);
    equations.unpack(y.data(), moment.state, moment.motion);
    return moment;
}

template <class F>
void for_each_choice(const F& f) {
    for (const CoordinateChoice choice : kChoices) { with_choice(choice, f); }
}

template <class C>
Energy energy_at(const Centroidal& scene, const DenseEquations<C>& equations, const std::vector<double>& y) {
    State state = start_state(scene.mechanism);
    Motion motion = start_motion(scene.mechanism);
    equations.unpack(y.data(), state, motion);
    return energy_of(scene, state, motion);
}

double sum_of(const Energy& energy) { return energy.kinetic + energy.potential; }

double distance(const State& a, const State& b) {
    double largest = 0.0;
    for (std::size_t k = 0; k < a.r.size(); ++k) {
        largest = std::max(
            {largest, (a.r[k] - b.r[k]).norm(), (rotation_matrix(a.p[k]) - rotation_matrix(b.p[k])).norm()});
    }
    return largest;
}

Mechanism free_body() {
    Mechanism mechanism;
    Body body;
    body.name = "free";
    body.p = euler_parameters_of(Vec3(1.0, 2.0, 3.0), 0.8);
    mechanism.bodies.push_back(body);
    return mechanism;
}

}  // namespace

TEST_CASE(
    "The schemes of slides 24 and 25 and both Euler parameter forms arrive at the same place",
    "[core][dynamics]") {
    test::Random random(11);
    for (const Mechanism& mechanism : {test::random_tree(random), test::rssr(0.7), test::four_bar_at(0.9)}) {
        const Centroidal scene = centroidal(mechanism, test::random_loads(random, mechanism));
        const test::Moment start = test::random_moment(random, scene, 0.0, 0.02);
        const test::Moment first = moved_on<OmegaLocal>(scene, start, 0.075, 60);
        for_each_choice([&](auto choice) {
            using C = decltype(choice);
            const test::Moment other = moved_on<C>(scene, start, 0.075, 60);
            // the error of order 8 is below rounding at this step: 7e-15 measured
            CHECK(distance(first.state, other.state) < 1e-12);
            CHECK(distance(first.state, start.state) > 0.02);
        });
    }
}

TEST_CASE("Energy stays with gravity and springs, in loops with redundant rows too", "[core][dynamics]") {
    test::Random random(5);
    for (const Mechanism& mechanism :
         {test::random_tree(random), test::rssr(0.7), test::four_bar_at(0.9), test::bennett(1.0),
          test::bricard(1.2)}) {
        const Centroidal scene = centroidal(mechanism, test::random_conservative_loads(random, mechanism));
        const test::Moment start = test::random_moment(random, scene, 0.0, 0.02);
        for_each_choice([&](auto choice) {
            DenseEquations<decltype(choice)> e(scene);
            std::vector<double> y(static_cast<std::size_t>(e.size()));
            e.pack(start.state, start.motion, y.data());
            const auto energy = [&] { return energy_at(scene, e, y); };
            const Energy before = energy();
            y = test::run(e, dormand_prince_853(), y, 0.075, 60, true);
            // rounding of energies of some 1e2 J: 2e-12 J measured, the same with half the step
            CHECK(std::abs(sum_of(energy()) - sum_of(before)) < 1e-11 * (1.0 + before.kinetic));
            CHECK(std::abs(energy().kinetic - before.kinetic) > 1e-3 * before.kinetic);
        });
    }
}

TEST_CASE("What loads and dampers put in is what the energy grows by", "[core][dynamics]") {
    test::Random random(6);
    for (const Mechanism& mechanism : {test::random_tree(random), test::four_bar_at(0.9)}) {
        const Centroidal scene = centroidal(mechanism, test::random_loads(random, mechanism));
        // all that has no potential: applied forces and torques, dampers
        Loads active = scene.loads;
        active.gravity.setZero();
        for (Spring& spring : active.springs) { spring.stiffness = 0.0; }
        for (RotationalSpring& spring : active.rotational_springs) { spring.stiffness = 0.0; }
        for (Bushing& bushing : active.bushings) { bushing.stiffness.setZero(); }
        const test::Moment start = test::random_moment(random, scene, 0.0, 0.02);
        DenseEquations<OmegaLocal> e(scene);
        const auto size = static_cast<std::size_t>(e.size());
        std::vector<double> y(size + 1, 0.0);  // the last one is the work done so far
        e.pack(start.state, start.motion, y.data());
        const auto f = [&](double t, const double* at, double* y_dot) {
            e.evaluate(t, at, y_dot);
            test::Moment moment = start;
            e.unpack(at, moment.state, moment.motion);
            const std::vector<BodyForce> forces = test::forces_of(active, moment, t);
            double power = 0.0;
            for (std::size_t b = 0; b < forces.size(); ++b) {
                power += forces[b].f.dot(moment.motion.r_dot[b]) +
                         forces[b].n_local.dot(moment.motion.omega_local[b]);
            }
            y_dot[size] = power;
        };
        const auto energy = [&] { return sum_of(energy_at(scene, e, y)); };
        const double before = energy();
        for (int n = 0; n < 120; ++n) {
            take_step(dormand_prince_853(), f, n * 0.00125, 0.00125, y);
            e.project((n + 1) * 0.00125, y.data());
        }
        CHECK(std::abs(y[size]) > 1e-2);
        // rounding of 1e2 J: 9e-13 J measured
        CHECK(std::abs(energy() - before - y[size]) < 1e-11);
    }
}

TEST_CASE("A free asymmetric body keeps its momenta and its energy in every choice", "[core][dynamics]") {
    const Mechanism mechanism = free_body();
    Loads loads;
    loads.masses = {MassProperties{2.0, Vec3::Zero(), Vec3(1.0, 2.0, 2.8).asDiagonal()}};
    const Centroidal scene = centroidal(mechanism, loads);
    test::Moment start{start_state(mechanism), zero_motion(mechanism)};
    start.motion.r_dot[0] = Vec3(0.3, -0.2, 0.1);
    start.motion.omega_local[0] = Vec3(0.1, 4.0, 0.1);  // about the middle axis: it tumbles
    const auto angular = [&](const test::Moment& m) -> Vec3 {
        return rotation_matrix(m.state.p[0]) * (loads.masses[0]->J_local * m.motion.omega_local[0]);
    };
    const auto energy = [&](const test::Moment& m) {
        return 0.5 * m.motion.omega_local[0].dot(loads.masses[0]->J_local * m.motion.omega_local[0]);
    };
    for_each_choice([&](auto choice) {
        const test::Moment end = moved_on<decltype(choice)>(scene, start, 5.0, 500);
        // 20 rad in 500 steps of order 8: 6e-12 measured
        CHECK((angular(end) - angular(start)).norm() < 1e-10);
        CHECK(std::abs(energy(end) - energy(start)) < 1e-10);
        CHECK((end.motion.r_dot[0] - start.motion.r_dot[0]).norm() < 1e-13);  // rounding of 500 steps
        CHECK((end.motion.omega_local[0] - start.motion.omega_local[0]).norm() > 1.0);
    });
}

TEST_CASE(
    "Constraints drift without treatment, stay bounded with Baumgarte's, and hold by projection",
    "[core][dynamics]") {
    test::SceneBuilder builder;
    const int body = builder.add_body("rod", Vec3(0.5, 0.0, 0.0));
    builder.add_joint("revolute", 0, body, Vec3::Zero(), Vec3::UnitZ());
    const Mechanism& mechanism = builder.mechanism;
    Loads loads;
    loads.masses = {std::nullopt, MassProperties{1.0, Vec3::Zero(), Mat3::Identity() / 12.0}};
    loads.gravity = Vec3(0.0, -9.81, 0.0);
    const Centroidal scene = centroidal(mechanism, loads);
    const test::Moment start{start_state(mechanism), zero_motion(mechanism)};
    // largest drift of rk4 with steps of 0.02 s, which is large enough to be seen
    const auto drift = [&](double duration, bool project, const Baumgarte& baumgarte) {
        DenseEquations<OmegaLocal> e(scene, baumgarte);
        std::vector<double> y(static_cast<std::size_t>(e.size()));
        e.pack(start.state, start.motion, y.data());
        double largest = 0.0;
        for (int n = 0; n < std::lround(duration / 0.02); ++n) {
            y = test::run(e, runge_kutta_4(), y, 0.02, 1, project);
            largest = std::max(largest, e.violation(0.0, y.data()).first);
        }
        return largest;
    };
    // measured: 1.3e-3 in 20 s without Baumgarte's terms; 5e-6 with them, the same as in 2 s
    const double none_2 = drift(2.0, false, {});
    const double none_20 = drift(20.0, false, {});
    const double baumgarte_2 = drift(2.0, false, {10.0, 10.0});
    const double baumgarte_20 = drift(20.0, false, {10.0, 10.0});
    CAPTURE(none_2, none_20, baumgarte_2, baumgarte_20);
    CHECK(none_20 > 5.0 * none_2);
    CHECK(baumgarte_20 < 5.0 * baumgarte_2);
    CHECK(baumgarte_20 < 0.1 * none_20);
    CHECK(drift(20.0, true, {}) < 1e-13);  // rounding: 1e-14 measured
}
