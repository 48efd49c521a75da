#include <catch2/catch.hpp>

#include "core/integrate/simulation.hpp"
#include "tests/support/driven.hpp"
#include "tests/support/random_dynamics.hpp"

using namespace jw;

namespace {

Motion block_accelerations(
    const Centroidal& scene, const test::Moment& moment, double t, const Baumgarte& baumgarte = {}) {
    const std::unique_ptr<MotionEquations> equations = block_equations(scene, baumgarte);
    const std::vector<int> moving = moving_bodies_of(scene.mechanism);
    const std::vector<double> y = test::flat_of(scene, moment);
    std::vector<double> y_dot(y.size());
    equations->choose_rows(t, y.data());
    equations->evaluate(t, y.data(), y_dot.data());
    Motion out = zero_motion(scene.mechanism);
    State ignored = moment.state;
    unpack(y_dot.data(), moving, ignored, out);
    return out;
}

int block_rows_left_out(const Centroidal& scene) {
    const std::unique_ptr<MotionEquations> equations = block_equations(scene);
    std::vector<double> y(static_cast<std::size_t>(equations->size()));
    const State start = start_state(scene.mechanism);
    pack(start, zero_motion(scene.mechanism), moving_bodies_of(scene.mechanism), y.data());
    equations->choose_rows(0.0, y.data());
    return equations->rows_left_out();
}

/// Contradiction between redundant rows: the error of an interpolated pose, 1e-10, times the size of Φq.
constexpr double kBetweenSteps = 1e-8;

double size_of(const Motion& motion) {
    Motion none = motion;
    for (Vec3& v : none.r_dot) { v.setZero(); }
    for (Vec3& v : none.omega_local) { v.setZero(); }
    return test::difference(motion, none);
}

}  // namespace

TEST_CASE("Masses 18 decades apart cost no digits, whoever carries whom", "[core][dynamics]") {
    for (const bool heavy_first : {false, true}) {
        test::Random random(4);
        int number = 0;
        for (const Mechanism& mechanism : test::mechanisms_of_all_kinds(random)) {
            CAPTURE(heavy_first, number);
            // a light body that can spin between heavy ones loses all digits: reactions of 1e10 N, which miss
            // its axis by rounding, turn it. This happens in the tree (0) and the RSSR (5)
            if (const int n = number++; n == 0 || n == 5) { continue; }
            Loads loads;
            loads.gravity = random.vector(9.81);
            loads.masses = test::random_masses(random, mechanism);
            bool heavy = heavy_first;
            for (auto& mass : loads.masses) {
                if (!mass) { continue; }
                const double factor = heavy ? 1e9 : 1e-9;
                mass->mass *= factor;
                mass->J_local *= factor;
                heavy = !heavy;
            }
            const Centroidal scene = centroidal(mechanism, loads);
            const double t = 0.3;
            const test::Moment moment = test::random_moment(random, scene, t);
            Motion block = block_accelerations(scene, moment, t);
            Motion dense = test::dense_accelerations<OmegaGlobal>(scene, moment, t);
            block.theta_dot.clear();
            dense.theta_dot.clear();
            // rounding times the condition of Φq, at most 1e3 here (1e18 if masses enter it). 3e-14 measured
            CHECK(test::difference(block, dense) / size_of(block) < 1e-11);
        }
    }
}

TEST_CASE("Block and dense equations give the same accelerations in all four choices", "[core][dynamics]") {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        test::Random random(seed);
        int number = 0;
        for (const Mechanism& mechanism : test::mechanisms_of_all_kinds(random)) {
            CAPTURE(seed, number++);
            const Centroidal scene = centroidal(mechanism, test::random_loads(random, mechanism));
            const double t = 0.3;
            const test::Moment moment = test::random_moment(random, scene, t);
            Motion block = block_accelerations(scene, moment, t);
            block.theta_dot.clear();
            const auto differs = [&](Motion dense) {
                dense.theta_dot.clear();
                return test::difference(block, dense) / size_of(block);
            };
            // rounding 1e-16 times the condition of Φq M⁻¹ Φqᵀ, 1e4 at most for these shapes and masses, and
            // ten times that for the worst of many; 3e-13 measured
            CHECK(differs(test::dense_accelerations<OmegaLocal>(scene, moment, t)) < 1e-10);
            CHECK(differs(test::dense_accelerations<OmegaGlobal>(scene, moment, t)) < 1e-10);
            CHECK(differs(test::dense_accelerations<TrueEulerParameters>(scene, moment, t)) < 1e-10);
            CHECK(differs(test::dense_accelerations<ModifiedEulerParameters>(scene, moment, t)) < 1e-10);
        }
    }
}

TEST_CASE("Baumgarte's terms are the same in block and dense equations", "[core][dynamics]") {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        test::Random random(seed);
        // primitives that have one form only: off the constraints two rows and a pair are not the same
        test::SceneBuilder builder;
        const int first = builder.add_body("first", random.vector(2.0));
        const int second = builder.add_body("second", random.vector(2.0));
        builder.add_joint("spherical", 0, first, random.vector(), random.direction());
        const Vec3 axis = random.direction();
        Joint& universal = builder.add_joint("universal", first, second, random.vector(), axis);
        universal.geometry.s_j_local = builder.local(second, perpendicular_to(axis));
        builder.add_distance(0, second, random.vector(), random.vector() + Vec3(3.0, 0.0, 0.0));
        builder.mechanism.drivers.push_back(
            {"rod", -1, first, second, SquaredDistanceMeasure{random.vector(), random.vector()},
             test::polynomial({2.0, 0.7, 0.3})});
        const Mechanism& mechanism = builder.mechanism;
        const Centroidal scene = centroidal(mechanism, test::random_loads(random, mechanism));
        test::Moment off{start_state(scene.mechanism), zero_motion(scene.mechanism)};
        for (const std::size_t b : {1U, 2U}) {
            off.state.r[b] += random.vector(0.1);
            off.motion.r_dot[b] = random.vector();
            off.motion.omega_local[b] = random.vector();
        }
        CAPTURE(seed);
        for (const Baumgarte& baumgarte : {Baumgarte{5.0, 0.0}, Baumgarte{0.0, 8.0}}) {
            const Motion block = block_accelerations(scene, off, 0.3, baumgarte);
            const Motion dense = test::dense_accelerations<OmegaLocal>(scene, off, 0.3, baumgarte);
            CHECK(test::difference(block, dense) < 1e-10 * size_of(block));  // as without the terms
            CHECK(test::difference(block, block_accelerations(scene, off, 0.3)) > 1e-2 * size_of(block));
        }
    }
}

TEMPLATE_TEST_CASE(
    "The solution satisfies M q'' - Phi_q^T lambda = Q and Phi_q q'' = gamma in every row, those left out "
    "included",
    "[core][dynamics]", TrueEulerParameters, ModifiedEulerParameters, OmegaLocal, OmegaGlobal) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
        test::Random random(seed);
        int number = 0;
        for (const Mechanism& mechanism : test::mechanisms_of_all_kinds(random)) {
            CAPTURE(seed, number++);
            const Centroidal scene = centroidal(mechanism, test::random_loads(random, mechanism));
            const test::Moment moment = test::random_moment(random, scene, 0.3);
            DenseEquations<TestType> e(scene);
            std::vector<double> y(static_cast<std::size_t>(e.size()));
            std::vector<double> y_dot(y.size());
            e.pack(moment.state, moment.motion, y.data());
            e.choose_rows(0.3, y.data());
            e.evaluate(0.3, y.data(), y_dot.data());

            const VectorX motion =
                e.mass_matrix() * e.acceleration() - e.jacobian().transpose() * e.lambda() - e.force();
            const VectorX rows = e.jacobian() * e.acceleration() - e.right_side();
            // the equations of motion are solved for λ: only rounding is left. For a redundant row the state
            // must be exact to rounding, too. 1e-15 and 2e-13 measured
            CHECK(motion.lpNorm<Eigen::Infinity>() < 1e-13 * (1.0 + e.force().norm()));
            CHECK(rows.lpNorm<Eigen::Infinity>() < 1e-11 * (1.0 + e.right_side().norm()));
        }
    }
}

TEST_CASE(
    "Accelerations between the steps of joint coordinates are those of a dense choice of rows",
    "[core][dynamics]") {
    int compared = 0;
    int with_rows_left_out = 0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
        test::Random random(seed);
        int number = 0;
        for (const Mechanism& mechanism : test::mechanisms_of_all_kinds(random)) {
            CAPTURE(seed, number++);
            SimulationSettings settings;
            settings.formulation = Formulation::joints;
            settings.tolerance = 1e-10;
            Simulation simulation(mechanism, test::random_loads(random, mechanism), settings);
            if (&simulation.integrated() == &simulation.equations()) { continue; }  // not in joints
            const Centroidal& scene = simulation.scene();
            const auto outcome =
                simulation.run({0.0, 0.013, 0.031, 0.05}, [&](double t, const std::vector<double>& y) {
                    test::Moment moment{start_state(scene.mechanism), start_motion(scene.mechanism)};
                    unpack(y.data(), moving_bodies_of(scene.mechanism), moment.state, moment.motion);
                    const Motion found = simulation.acceleration(t, y);
                    Motion dense = test::dense_accelerations<OmegaLocal>(scene, moment, t);
                    dense.theta_dot = found.theta_dot;  // not compared: follows from the others
                    CAPTURE(t);
                    CHECK(test::difference(found, dense) < kBetweenSteps * size_of(dense));
                    ++compared;
                    with_rows_left_out += simulation.equations().rows_left_out() > 0 ? 1 : 0;
                });
            CHECK_FALSE(outcome.failure);
        }
    }
    CHECK(compared > 200);
    CHECK(with_rows_left_out > 50);
}

TEST_CASE("Rows left out are as many as the rank says", "[core][dynamics]") {
    struct Case {
        Mechanism mechanism;
        int redundant;
    };
    // rank table of the loops: four-bar 20 - 17, Bennett 20 - 17, Bricard 30 - 29, Cardan on bearings 14 - 11
    for (const Case& c : std::vector<Case>{
             {test::four_bar_at(0.7), 3},
             {test::bennett(1.0), 3},
             {test::bricard(1.2), 1},
             {test::cardan(0.5, 0.3), 3},
             {test::rssr(0.7), 0}}) {
        test::Random random(7);
        const Centroidal scene =
            centroidal(c.mechanism, Loads{test::random_masses(random, c.mechanism), {}, {}, {}, {}, {}, {}});
        for (const CoordinateChoice choice :
             {CoordinateChoice::omega_local, CoordinateChoice::omega_global,
              CoordinateChoice::true_euler_parameters, CoordinateChoice::modified_euler_parameters}) {
            CHECK(dense_equations(scene, choice)->rows_left_out() == c.redundant);
        }
        CHECK(block_rows_left_out(scene) == c.redundant);
    }
}

TEST_CASE("A choice of rows that is taken back leaves the equations as they were", "[core][dynamics]") {
    // at turned bodies the rule of slide 5 drops other rows, and pivots keep others
    test::Random random(4);
    for (const Mechanism& mechanism : {test::random_tree(random), test::bricard(1.2)}) {
        const Centroidal scene = centroidal(mechanism, test::random_loads(random, mechanism));
        const test::Moment moment = test::random_moment(random, scene, 0.0, 0.02);
        DenseEquations<OmegaLocal> e(scene);
        std::vector<double> y(static_cast<std::size_t>(e.size()));
        std::vector<double> y_dot(y.size());
        e.pack(moment.state, moment.motion, y.data());
        e.evaluate(0.0, y.data(), y_dot.data());
        const VectorX lambda = e.lambda();
        test::Moment turned = moment;
        for (Vec4& p : turned.state.p) { p = turned_global(p, Vec3(0.9, 0.7, -1.1)); }
        std::vector<double> y_turned = y;
        e.pack(turned.state, turned.motion, y_turned.data());
        REQUIRE(e.choose_rows(0.0, y_turned.data()));
        e.evaluate(0.0, y.data(), y_dot.data());
        CHECK((e.lambda() - lambda).norm() > 1e-3 * lambda.norm());
        e.take_back_rows();
        e.evaluate(0.0, y.data(), y_dot.data());
        CHECK((e.lambda() - lambda).norm() == 0.0);
    }
}
