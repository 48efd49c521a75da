#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

#include <Eigen/SVD>

#include "core/kinematics/manifold.hpp"
#include "core/poses/branches.hpp"
#include "tests/support/driven.hpp"
#include "tests/support/singular_scenes.hpp"

using namespace jw;
using test::kPi;

namespace {

/// A dragged mechanism that checks after every pull that it is still assembled.
struct Scene {
    explicit Scene(Mechanism m) : mechanism(std::move(m)), dragger(system, start_state(mechanism), 0.0) {}

    Vec3 local(int body, const Vec3& global) const {
        const Body& b = mechanism.bodies[static_cast<std::size_t>(body)];
        return rotation_matrix(b.p).transpose() * (global - b.r);
    }
    Vec3 global(int body, const Vec3& point_local) const {
        const auto b = static_cast<std::size_t>(body);
        return dragger.state().r[b] + rotation_matrix(dragger.state().p[b]) * point_local;
    }
    DragOutcome pull(int body, const Vec3& point_local, const Vec3& target) {
        const DragOutcome outcome = dragger.pull(body, point_local, target);
        Assembler<OmegaLocal> assembler(system);
        assembler.assemble_phi_and_jacobian(dragger.state(), 0.0);
        // Newton's tolerance, for the largest coordinate of the scene
        const double tolerance = residual_tolerance(system, dragger.state());
        if (assembler.phi().size() > 0) {
            const VectorX scaled = assembler.phi().cwiseQuotient(scaling_of<OmegaLocal>(system).row);
            CHECK(scaled.cwiseAbs().maxCoeff() <= tolerance);
        }
        CHECK(outcome.residual <= tolerance);
        return outcome;
    }
    DragOutcome pull_often(int body, const Vec3& point_local, const Vec3& target, int pulls = 30) {
        DragOutcome outcome;
        for (int k = 0; k < pulls; ++k) { outcome = pull(body, point_local, target); }
        return outcome;
    }

    Mechanism mechanism;
    System system{mechanism, everything(mechanism)};
    Dragger dragger;
};

/// Links of length 1 along x, joints in turn about z and y.
Mechanism chain(int links, const char* type) {
    test::SceneBuilder scene;
    int before = 0;
    for (int k = 0; k < links; ++k) {
        const int body = scene.add_body("link", Vec3(k + 0.5, 0.0, 0.0));
        scene.add_joint(type, before, body, Vec3(k, 0.0, 0.0), k % 2 == 0 ? Vec3::UnitZ() : Vec3::UnitY());
        before = body;
    }
    return scene.mechanism;
}

/// A point of the coupler, 1 along A B and 1 beside it, from the closed form.
Vec3 coupler_point(double phi) {
    const test::FourBarLengths l;
    const Vec3 A = l.crank * Vec3(std::cos(phi), std::sin(phi), 0.0);
    const Vec3 B = test::circles_meet(A, l.coupler, l.ground * Vec3::UnitX(), l.rocker, 1.0);
    const Vec3 u = (B - A).normalized();
    return A + u + Vec3::UnitZ().cross(u);
}

}  // namespace

TEST_CASE("The free part of a motion is its projection on the null space", "[core][manifold]") {
    for (const Mechanism& mechanism :
         {test::four_bar_at(0.7), test::bennett(1.1), test::rssr(0.7), test::cardan(0.5, 0.3)}) {
        const System system(mechanism, everything(mechanism));
        const Scaling scaling = scaling_of<OmegaLocal>(system);
        const MatrixX jacobian = test::jacobian_of<OmegaLocal>(mechanism);
        LeastSquares least_squares(scaling);
        least_squares.compute(test::sparse_jacobian_of<OmegaLocal>(mechanism));
        const int rank = least_squares.rank(1e-9);
        const Eigen::JacobiSVD<MatrixX> svd(jacobian, Eigen::ComputeFullU | Eigen::ComputeFullV);
        const MatrixX null = svd.matrixV().rightCols(jacobian.cols() - rank);
        test::Random random(4);
        VectorX x(jacobian.cols());
        for (double& entry : x) { entry = random.number(); }
        const VectorX expected = null * (null.transpose() * x);
        VectorX free = x;
        least_squares.keep_free_part(rank, free);
        // rows are not all of size 1 but the space is the same: rounding times a condition of some tens
        CHECK((free - expected).norm() < 1e-13);

        // the multipliers give the part that is not free
        VectorX lambda;
        least_squares.solve_transposed(x, rank, lambda);
        CHECK((x - jacobian.transpose() * lambda - expected).norm() < 1e-13);
    }
}

TEST_CASE("A crank dragged round and round takes the loop along on its branch", "[core][manifold]") {
    Scene scene(test::four_bar_at(0.7));
    const Vec3 pin = scene.local(1, Vec3(std::cos(0.7), std::sin(0.7), 0.0));
    const Vec3 point = scene.local(2, coupler_point(0.7));
    int iterations = 0;
    for (int k = 1; k <= 120; ++k) {
        const double phi = 0.7 + 0.1 * k;
        CAPTURE(phi);
        const DragOutcome outcome =
            scene.pull(1, pin, 1.7 * Vec3(std::cos(phi), std::sin(phi), 0.0));  // outside the circle
        iterations += outcome.newton_iterations;
        CHECK(outcome.freedoms == 1);
        // the nearest point of the circle, as accurately as 1e-13 of ½ distance² determines it
        CHECK((scene.global(1, pin) - Vec3(std::cos(phi), std::sin(phi), 0.0)).norm() < 1e-6);
        CHECK((scene.global(2, point) - coupler_point(phi)).norm() < 1e-5);
        CHECK(outcome.distance == Approx(0.7).epsilon(1e-9));
    }
    CHECK(iterations < 120 * 10);
}

TEST_CASE("A point in reach is brought to its target", "[core][manifold]") {
    Scene scene(test::four_bar_at(0.7));
    const Vec3 point = scene.local(2, coupler_point(0.7));
    for (const double phi : {0.9, 1.4, 0.4, 6.0}) {
        CAPTURE(phi);
        const DragOutcome outcome = scene.pull_often(2, point, coupler_point(phi), 5);
        CHECK(outcome.distance < 1e-8);
        CHECK_FALSE(outcome.blocked);
    }
    for (const char* type : {"revolute", "spherical"}) {
        CAPTURE(type);
        Scene arm(chain(10, type));
        // ten steps of a fifth of the arm's length and some more
        const DragOutcome outcome = arm.pull_often(10, arm.local(10, Vec3(10.0, 0.0, 0.0)), Vec3(3, 4, 2), 8);
        CHECK(outcome.distance < 1e-8 * 10.0);
        CHECK_FALSE(outcome.blocked);
    }
}

TEST_CASE(
    "Pulled at a target out of reach, a point slides to the nearest place and rests", "[core][manifold]") {
    test::Random random(8);
    for (int k = 0; k < 40; ++k) {
        Scene scene(test::four_bar_at(0.7));
        const Vec3 point = scene.local(2, coupler_point(0.7));
        const double far = k % 4 == 0 ? 1e4 : 4.0;
        const Vec3 target = random.vector(far);
        CAPTURE(k, target.transpose());
        scene.pull_often(2, point, target, 9);
        const State ninth = scene.dragger.state();
        const DragOutcome tenth = scene.pull(2, point, target);
        CHECK(movement(scene.system, ninth, scene.dragger.state()) < 1e-9);
        CHECK(tenth.blocked);
        // no point of the coupler curve within 0.1 rad of the crank is nearer, up to 1e-13 of distance² (of
        // targets that are brought to ten sizes of the machine)
        const Vec3 pin = scene.global(1, scene.local(1, Vec3(std::cos(0.7), std::sin(0.7), 0.0)));
        const double phi = std::atan2(pin.y(), pin.x());
        for (int step = -100; step <= 100; ++step) {
            CHECK((coupler_point(phi + 1e-3 * step) - target).norm() > tenth.distance - 1e-11 * far);
        }
    }
    for (const char* type : {"revolute", "spherical"}) {
        CAPTURE(type);
        Scene arm(chain(10, type));
        const Vec3 target(3.0, 14.0, 2.0);
        const Vec3 tip = arm.local(10, Vec3(10.0, 0.0, 0.0));
        arm.pull_often(10, tip, target, 9);
        const State ninth = arm.dragger.state();
        const DragOutcome tenth = arm.pull(10, tip, target);
        CHECK(movement(arm.system, ninth, arm.dragger.state()) < 1e-9);
        if (std::string(type) == "spherical") {
            // the arm is straight
            CHECK(tenth.distance == Approx(target.norm() - 10.0).epsilon(1e-9));
        }
    }
}

TEST_CASE("Where nothing can move, a pull is blocked and changes nothing", "[core][manifold]") {
    struct Line {
        const char* name;
        Mechanism mechanism;
        int body;
        int freedoms;
    };
    Mechanism weld = chain(1, "fixed");
    for (const Line& line :
         {Line{"driven", test::driven(test::four_bar_at(0.7), 0, 1.0), 2, 0},
          Line{"ground", test::four_bar_at(0.7), 0, 1}, Line{"weld", weld, 1, 0},
          // a freedom of velocity only: the bars are in line
          Line{"stretched", test::stretched_bars(), 1, 1},
          Line{"stretched", test::stretched_revolutes(), 1, 1}}) {
        CAPTURE(line.name);
        Scene scene(line.mechanism);
        const State before = scene.dragger.state();
        const Vec3 point = scene.local(line.body, Vec3(1.0, 0.0, 0.0));
        const Vec3 from = scene.global(line.body, point);
        const Vec3 target = from + Vec3(0.1, 0.7, 0.2);
        const DragOutcome outcome = scene.pull(line.body, point, target);
        CHECK(outcome.blocked);
        CHECK(outcome.freedoms == line.freedoms);
        CHECK(outcome.distance == Approx((target - from).norm()).epsilon(1e-14));
        CHECK(movement(scene.system, before, scene.dragger.state()) == 0.0);
        CHECK_FALSE(scene.pull(line.body, point, from).blocked);  // it is there already
    }
}

TEST_CASE("From a change point a pull leads onto either branch", "[core][manifold]") {
    // at φ = 0 the coupler may go parallel or cross over; a point at its middle goes up on both, its end
    // pulled against the crank only on the second
    Scene parallel(test::parallelogram(0.0));
    const Vec3 up(1.8, 0.8, 0.0);
    const Vec3 middle = parallel.local(2, Vec3(2.0, 0.0, 0.0));
    parallel.pull_often(2, middle, up, 5);
    CHECK(parallel.global(2, middle).y() > 0.3);

    Scene both(test::parallelogram(0.0));
    const Vec3 rocker_end = both.local(3, Vec3(3.0, 0.0, 0.0));
    for (const double side : {1.0, -1.0}) {
        const DragOutcome outcome = both.pull_often(3, rocker_end, Vec3(2.6, 0.8 * side, 0.0), 8);
        CAPTURE(side);
        CHECK(outcome.distance < 1e-8);
    }
    // back and across the change point again: the pull passes a collinear pose and does not get stuck
    const DragOutcome back = both.pull_often(3, rocker_end, Vec3(3.0, 0.0, 0.0), 8);
    CHECK(back.distance < 1e-6);
    const DragOutcome on = both.pull_often(3, rocker_end, Vec3(2.0 + std::cos(0.5), std::sin(0.5), 0.0), 8);
    CHECK(on.distance < 1e-8);
}

TEST_CASE("However wildly it is pulled, a four-bar keeps its branch", "[core][manifold]") {
    // a crank that turns fully never lets A B D fold: the coupler stays left of A -> D
    Scene scene(test::four_bar_at(0.7));
    test::Random random(12);
    const Vec3 A_local = scene.local(2, Vec3(std::cos(0.7), std::sin(0.7), 0.0));
    const Vec3 D(3.0, 0.0, 0.0);
    const Vec3 B_local =
        scene.local(2, test::circles_meet(Vec3(std::cos(0.7), std::sin(0.7), 0.0), 2.5, D, 2.0, 1.0));
    for (int k = 0; k < 200; ++k) {
        const int body = 1 + k % 3;
        scene.pull(body, random.vector(2.0), random.vector(6.0));
        const Vec3 A = scene.global(2, A_local);
        const Vec3 B = scene.global(2, B_local);
        CAPTURE(k);
        CHECK((D - A).cross(B - A).z() > 0.5);
        CHECK_FALSE(find_wrong_branch(scene.system, scene.dragger.state(), intended_sides(scene.system)));
    }
}

TEST_CASE("Targets without number or far beyond the machine do no harm", "[core][manifold]") {
    Scene scene(test::four_bar_at(0.7));
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    const State before = scene.dragger.state();
    for (const double x : {kNan, kInfinite, -kInfinite}) {
        for (const DragOutcome& outcome :
             {scene.pull(2, Vec3::UnitX(), Vec3(x, 0.0, 0.0)),
              scene.pull(2, Vec3(0.0, x, 0.0), Vec3::UnitX())}) {
            CHECK(outcome.distance == 0.0);
            CHECK(movement(scene.system, before, scene.dragger.state()) == 0.0);
        }
    }
    const Vec3 point = scene.local(2, coupler_point(0.7));
    const DragOutcome huge = scene.pull_often(2, point, Vec3(1e308, 1e308, 0.0));
    CHECK(std::isfinite(huge.distance));
    const Vec3 there = scene.global(2, point);
    Scene near(test::four_bar_at(0.7));
    near.pull_often(2, point, Vec3(1e8, 1e8, 0.0));
    // the same direction gives the same place, as accurately as 1e-13 of distance² determines it
    CHECK((near.global(2, point) - there).norm() < 1e-5);
    CHECK_THROWS_AS(scene.dragger.pull(4, point, there), std::invalid_argument);
    CHECK_THROWS_AS(scene.dragger.pull(-1, point, there), std::invalid_argument);
}

TEST_CASE("A pull does not depend on the size of the machine", "[core][manifold]") {
    const Mechanism mechanism = test::rssr(0.7);
    for (const double size : {1e-3, 0.05, 40.0, 1e3}) {
        CAPTURE(size);
        Scene one(mechanism);
        Scene other(scaled(mechanism, size));
        const Vec3 point(0.1, 0.2, -0.1);
        const DragOutcome expected = one.pull_often(2, point, Vec3(0.5, 1.0, 1.0), 12);
        const DragOutcome outcome = other.pull_often(2, size * point, size * Vec3(0.5, 1.0, 1.0), 12);
        CHECK(outcome.distance == Approx(size * expected.distance).epsilon(1e-9));
        CHECK(outcome.freedoms == 2);
        CHECK(outcome.blocked);
        // 1e-13 of distance² leaves a millionth of the angle; the idle spin depends on the way
        CHECK(turn_local_between(one.dragger.state().p[1], other.dragger.state().p[1]).norm() < 1e-5);
        CHECK(turn_local_between(one.dragger.state().p[3], other.dragger.state().p[3]).norm() < 1e-5);
    }
}

TEST_CASE("A nut pulled along its spindle turns with its thread, round after round", "[core][manifold]") {
    Scene scene(test::screw(0.7, 0.25, ScrewAngleForm::rotation));
    const Vec3 axis = Vec3(1.0, 2.0, 2.0) / 3.0;
    const Vec3 target = 5.0 * axis;  // 20 rad further
    const DragOutcome outcome = scene.pull_often(1, Vec3::Zero(), target, 60);
    CHECK(outcome.distance < 1e-8);
    CHECK(scene.dragger.state().theta[0] == Approx(20.0).epsilon(1e-9));
}

TEST_CASE("A free body follows a pull without limits", "[core][manifold]") {
    test::SceneBuilder builder;
    builder.add_body("free", Vec3(1.0, 2.0, 3.0));
    Scene scene(builder.mechanism);
    const DragOutcome outcome = scene.pull_often(1, Vec3(0.5, 0.1, 0.0), Vec3(20.0, -7.0, 5.0), 20);
    CHECK(outcome.freedoms == 6);
    CHECK(outcome.distance < 1e-8);
}

TEST_CASE("A state next to the constraints is projected onto them, or left as it is", "[core][manifold]") {
    const Mechanism mechanism = test::four_bar_at(0.7);
    System system(mechanism, everything(mechanism));
    for (unsigned seed = 1; seed <= 10; ++seed) {
        test::Random random(seed);
        State state = test::disturbed(mechanism, start_state(mechanism), random, 0.05, 0.05);
        const State before = state;
        CHECK(project(system, state, 0.0));
        Assembler<OmegaLocal> assembler(system);
        assembler.assemble_phi_and_jacobian(state, 0.0);
        CHECK(assembler.phi().cwiseAbs().maxCoeff() < 1e-12);
        // no further than a few times the disturbance
        CHECK(movement(system, before, state) < 0.3);
    }
    Mechanism torn = mechanism;
    torn.joints[3].geometry.P_i_local *= 5.0;  // a bearing out of reach
    System open(torn, everything(torn));
    State state = start_state(torn);
    CHECK_FALSE(project(open, state, 0.0));
    CHECK(movement(open, start_state(torn), state) == 0.0);
    State nowhere = start_state(mechanism);
    nowhere.r[1].x() = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(project(system, nowhere, 0.0));
}
