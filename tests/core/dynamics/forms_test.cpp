#include <catch2/catch.hpp>

#include "core/motion/tree/tree_equations.hpp"
#include "tests/support/driven.hpp"
#include "tests/support/random_dynamics.hpp"

/// Results of block and dense equations besides accelerations.
using namespace jw;

namespace {

struct Named {
    std::string name;
    std::unique_ptr<MotionEquations> equations;
};

std::vector<Named> all_forms(const Centroidal& scene) {
    std::vector<Named> out;
    out.push_back({"block", block_equations(scene)});
    for (const CoordinateChoice choice :
         {CoordinateChoice::omega_local, CoordinateChoice::omega_global,
          CoordinateChoice::true_euler_parameters, CoordinateChoice::modified_euler_parameters}) {
        out.push_back({"dense " + std::to_string(static_cast<int>(choice)), dense_equations(scene, choice)});
    }
    return out;
}

double most_apart(const std::vector<double>& a, const std::vector<double>& b) {
    REQUIRE(a.size() == b.size());
    double largest = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) { largest = std::max(largest, std::abs(a[k] - b[k])); }
    return largest;
}

/// A mechanism with loads, moved away from its start.
struct Moved {
    Centroidal scene;
    std::vector<double> flat;
};

std::vector<Moved> moved_scenes(unsigned seed) {
    test::Random random(seed);
    std::vector<Moved> out;
    for (const Mechanism& mechanism : test::mechanisms_of_all_kinds(random)) {
        Moved one{centroidal(mechanism, test::random_conservative_loads(random, mechanism)), {}};
        one.flat = test::flat_of(one.scene, test::random_moment(random, one.scene, 0.3));
        out.push_back(std::move(one));
    }
    return out;
}

}  // namespace

TEST_CASE("States of all forms are one and the same flat state", "[core][dynamics][forms]") {
    for (const Moved& scene : moved_scenes(1)) {
        std::vector<double> first;
        for (const Named& form : all_forms(scene.scene)) {
            CAPTURE(form.name);
            MotionEquations& e = *form.equations;
            std::vector<double> y(at(e.size()));
            std::vector<double> y_dot(y.size());
            std::vector<double> back(scene.flat.size());
            e.from_flat(scene.flat.data(), y.data());
            e.to_flat(y.data(), back.data());
            // rounding of some products
            CHECK(most_apart(scene.flat, back) < 1e-13);
            // values and rates of the interpolated numbers determine all of y
            e.choose_rows(0.3, y.data());
            e.evaluate(0.3, y.data(), y_dot.data());
            const auto count = static_cast<std::size_t>(e.interpolated());
            std::vector<double> known(3 * count);
            e.derivatives(y.data(), y_dot.data(), known.data());
            std::vector<double> again(y.size());
            e.state_of(known.data(), known.data() + count, again.data());
            CHECK(most_apart(y, again) < 1e-13);
            // rounding of accelerations (accelerations_test.cpp), by their size
            if (first.empty()) { first = known; }
            double size = 1.0;
            for (const double number : known) { size = std::max(size, std::abs(number)); }
            CHECK(most_apart(first, known) < 1e-10 * size);
        }
    }
}

TEST_CASE("Projections of all forms meet the equations and what drivers ask for", "[core][dynamics][forms]") {
    test::Random random(3);
    for (const Moved& scene : moved_scenes(3)) {
        std::vector<double> off = scene.flat;
        for (double& number : off) { number += random.number(-0.01, 0.01); }
        for (const Named& form : all_forms(scene.scene)) {
            CAPTURE(form.name);
            MotionEquations& e = *form.equations;
            std::vector<double> y(at(e.size()));
            e.from_flat(scene.flat.data(), y.data());
            e.choose_rows(0.3, y.data());
            e.from_flat(off.data(), y.data());
            e.project(0.3, y.data());
            std::vector<double> flat(off.size());
            e.to_flat(y.data(), flat.data());
            const auto dense = dense_equations(scene.scene, CoordinateChoice::omega_local);
            const auto [phi, phi_dot] = dense->violation(0.3, flat.data());
            CHECK(phi < 1e-11);
            CHECK(phi_dot < 1e-10);
        }
    }
}

TEST_CASE(
    "Free motions of the block equations are some, and leave all rows alone", "[core][dynamics][forms]") {
    test::Random random(4);
    for (const Mechanism& mechanism : {test::four_bar_at(0.7), test::rssr(0.7), test::random_tree(random)}) {
        const Centroidal scene =
            centroidal(mechanism, Loads{test::random_masses(random, mechanism), {}, {}, {}, {}, {}, {}});
        const std::vector<double> y = flat_start(scene.mechanism);
        const auto block = block_equations(scene);
        block->choose_rows(0.0, y.data());
        std::vector<double> drawn(at(block->velocities()));
        for (double& number : drawn) { number = random.number(); }
        std::vector<ProbedBody> bodies(at(block->bodies()));
        REQUIRE(block->free_motion(0.0, y.data(), drawn, bodies));
        // the free motion as velocities, which must satisfy the rates of all equations
        std::vector<double> moving = y;
        double size = 0.0;
        for (std::size_t m = 0; m < bodies.size(); ++m) {
            double* numbers = body_numbers(moving.data(), m);
            vec3(numbers + 7) = bodies[m].free_way;
            vec3(numbers + 10) = rotation_matrix(vec4(numbers + 3)).transpose() * bodies[m].free_turn;
            size = std::max({size, bodies[m].free_way.norm(), bodies[m].free_turn.norm()});
        }
        CHECK(size > 1e-2);
        const auto dense = dense_equations(scene, CoordinateChoice::omega_local);
        CHECK(dense->violation(0.0, moving.data()).second < 1e-12 * size);
    }
}

TEST_CASE("A driver of the block equations prescribes the value that was set", "[core][dynamics][forms]") {
    Mechanism mechanism = test::driven(test::four_bar_at(0.7), 0, 1.5);
    mechanism.drivers.push_back(mechanism.drivers.front());
    mechanism.drivers.back().function = test::polynomial({0.2});
    test::Random random(5);
    const Centroidal scene =
        centroidal(mechanism, Loads{test::random_masses(random, mechanism), {}, {}, {}, {}, {}, {}});
    const std::vector<double> y = flat_start(scene.mechanism);
    const auto block = block_equations(scene);
    const double f = mechanism.drivers.front().function.polynomial.front();
    // before it is set, the other driver prescribes a different angle
    CHECK(block->violation(0.0, y.data()).first > 1e-2);
    block->set_driver(1, f, 0.0);
    CHECK(block->violation(0.0, y.data()).first < 1e-12);
    block->set_driver(1, f - 0.5, 1.0);
    CHECK(block->violation(0.5, y.data()).first > 1e-2);
}

TEST_CASE("A single row of the block equations keeps all of itself", "[core][dynamics][forms]") {
    test::Random random(6);
    test::SceneBuilder builder;
    builder.add_body("body", random.vector());
    builder.add_distance(0, 1, random.vector(), random.vector() + Vec3(3.0, 0.0, 0.0));
    const Centroidal scene = centroidal(
        builder.mechanism, Loads{test::random_masses(random, builder.mechanism), {}, {}, {}, {}, {}, {}});
    const std::vector<double> y = flat_start(scene.mechanism);
    std::vector<double> y_dot(y.size());
    const auto block = block_equations(scene);
    block->choose_rows(0.0, y.data());
    block->evaluate(0.0, y.data(), y_dot.data());
    CHECK(block->smallest_pivot() == Approx(1.0).epsilon(1e-12));
}

TEST_CASE("The block equations begin with the turns that a nut's place tells", "[core][dynamics][forms]") {
    constexpr double alpha = 0.25;
    const Mechanism mechanism = test::screw(0.7, alpha, ScrewAngleForm::rotation);
    test::Random random(7);
    const Centroidal scene =
        centroidal(mechanism, Loads{test::random_masses(random, mechanism), {}, {}, {}, {}, {}, {}});
    const std::vector<double> y = flat_start(scene.mechanism);
    const auto block = block_equations(scene);
    block->choose_rows(0.0, y.data());
    block->begin_turns(0.0, y.data());
    std::vector<double> up = y;
    vec3(up.data()) += 6.0 * test::kPi * alpha * Vec3(1.0, 2.0, 2.0).normalized();
    // three turns up the thread, which the screw has not made
    std::vector<double> pulled = up;
    CHECK(block->project(0.0, pulled.data()) > 1e-2);
    // a motion that begins there has made these turns
    block->begin_turns(0.0, up.data());
    CHECK(block->project(0.0, up.data()) < 1e-12);
}

TEST_CASE("Joint coordinates know the turns of a screw that closes a loop", "[core][dynamics][forms]") {
    constexpr double alpha = 0.25;
    const Vec3 axis(1.0, 2.0, 2.0);
    test::SceneBuilder lathe;
    const int spindle = lathe.add_body("spindle", Vec3::Zero());
    const int carriage = lathe.add_body("carriage", 0.7 * alpha * axis.normalized());
    lathe.add_joint("revolute", 0, spindle, Vec3::Zero(), axis);
    lathe.add_joint("prismatic", 0, carriage, Vec3::Zero(), axis);
    Joint& joint = lathe.add_joint("screw", spindle, carriage, Vec3::Zero(), axis);
    const Vec3 u_i = perpendicular_to(axis);
    lathe.measure_angle(joint, u_i, Eigen::AngleAxisd(0.7, axis.normalized()) * u_i);
    joint.geometry.P_j_local = Vec3::Zero();
    joint.geometry.alpha = alpha;
    const Mechanism& mechanism = lathe.mechanism;
    test::Random random(7);
    const Centroidal scene =
        centroidal(mechanism, Loads{test::random_masses(random, mechanism), {}, {}, {}, {}, {}, {}});
    const std::vector<double> flat = flat_start(scene.mechanism);
    TreeEquations tree(scene, flat);
    REQUIRE(tree.rows() > 0);
    std::vector<double> y(static_cast<std::size_t>(tree.size()));
    tree.from_flat(flat.data(), y.data());
    tree.choose_rows(0.0, y.data());
    tree.begin_turns(0.0, y.data());
    CHECK(tree.violation(0.0, y.data()).first < 1e-12);
    // a turn up the thread, along the axis only
    std::vector<double> pulled = y;
    const std::vector<NumberScale> scales = tree.scales();
    const auto way = std::ranges::find(scales, NumberScale::Kind::way, &NumberScale::kind);
    REQUIRE(way != scales.end());
    pulled[static_cast<std::size_t>(way - scales.begin())] += 2.0 * test::kPi * alpha;
    CHECK(tree.violation(0.0, pulled.data()).first > 1e-2);
    // a motion that begins there has made that turn
    tree.begin_turns(0.0, pulled.data());
    CHECK(tree.violation(0.0, pulled.data()).first < 1e-12);
}
