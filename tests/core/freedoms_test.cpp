#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

#include "core/kinematics/freedoms.hpp"
#include "core/kinematics/proof/step_proof.hpp"
#include "core/poses/branches.hpp"
#include "core/poses/newton.hpp"
#include "tests/support/driven.hpp"
#include "tests/support/singular_scenes.hpp"

using namespace jw;
using test::kPi;

namespace {

constexpr double kStep = 0.1;

double largest_residual(const System& system, const State& state) {
    Assembler<OmegaLocal> assembler(system);
    assembler.assemble_phi_and_jacobian(state, 0.0);
    return assembler.phi().size() == 0 ? 0.0 : assembler.phi().cwiseAbs().maxCoeff();
}

/// Motion followed from the start pose, with every state checked.
FollowedMotion followed(const Mechanism& mechanism, const VectorX& direction, int steps = 8) {
    const System system(mechanism, everything(mechanism));
    FollowedMotion motion = follow_free_motion(system, start_state(mechanism), 0.0, direction, steps, kStep);
    REQUIRE(motion.start < static_cast<int>(motion.states.size()));
    CHECK(
        movement(system, start_state(mechanism), motion.states[static_cast<std::size_t>(motion.start)]) ==
        0.0);
    for (const State& state : motion.states) { CHECK(largest_residual(system, state) < 1e-12); }
    for (std::size_t k = 1; k < motion.states.size(); ++k) {
        const double step = movement(system, motion.states[k - 1], motion.states[k]);
        // neither a stop nor a jump; displacements are counted in sizes of the machine, up to 4 m here
        CHECK(step > 0.1 * kStep);
        CHECK(step < 5.0 * kStep);
    }
    return motion;
}

std::vector<FreeMotion> free_motions(const Mechanism& mechanism) {
    return test::rank_of(mechanism).free_motions;
}

/// Columns of a motion at the start pose, whose angular velocities are given in the global frame [rad/s].
VectorX columns_of(const Mechanism& mechanism, const Motion& global) {
    const System system(mechanism, everything(mechanism));
    Motion motion = global;
    for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
        motion.omega_local[b] = rotation_matrix(mechanism.bodies[b].p).transpose() * global.omega_local[b];
    }
    return Layout<OmegaLocal>(system).columns_of(start_state(mechanism), motion);
}

/// Velocities of the parallelogram at φ = 0: crank and rocker turn at these rates, the coupler by half the
/// difference.
VectorX parallelogram_motion(double crank, double rocker) {
    const Mechanism mechanism = test::parallelogram(0.0);
    Motion motion = zero_motion(mechanism);
    motion.omega_local[1] = crank * Vec3::UnitZ();
    motion.omega_local[2] = 0.5 * (rocker - crank) * Vec3::UnitZ();
    motion.omega_local[3] = rocker * Vec3::UnitZ();
    motion.r_dot[2] = crank * Vec3::UnitY();  // its origin is the crank's pin
    return columns_of(mechanism, motion);
}

}  // namespace

TEST_CASE("The free crank of a four-bar is a finite motion both ways", "[core][freedoms]") {
    const Mechanism mechanism = test::four_bar_at(0.7);
    const FollowedMotion motion = followed(mechanism, free_motions(mechanism).at(0), 70);
    CHECK(motion.is_finite());
    CHECK(motion.start == 70);
    REQUIRE(motion.states.size() == 141);
    double last = relative_angle(mechanism.joints[0], motion.states.front());
    double turned = 0.0;
    for (const State& state : motion.states) {
        const double angle = relative_angle(mechanism.joints[0], state);
        const double step = std::remainder(angle - last, 2.0 * kPi);
        CHECK(turned * step >= 0.0);  // never back
        turned += step;
        last = angle;
        // the rocker as the closed form has it
        const Vec3 A(std::cos(angle), std::sin(angle), 0.0);
        const Vec3 B = test::circles_meet(A, 2.5, 3.0 * Vec3::UnitX(), 2.0, 1.0) - 3.0 * Vec3::UnitX();
        const double rocker = relative_angle(mechanism.joints[3], state);
        CHECK(std::abs(std::remainder(rocker - std::atan2(B.y(), B.x()), 2.0 * kPi)) < 1e-12 * 10.0);
    }
    CHECK(std::abs(turned) > 2.0 * kPi);  // round and round
}

TEST_CASE("Bars in line have a free velocity but no finite motion", "[core][freedoms]") {
    for (const Mechanism& mechanism : {test::stretched_bars(), test::stretched_revolutes()}) {
        REQUIRE(free_motions(mechanism).size() == 1);
        const FollowedMotion motion = followed(mechanism, free_motions(mechanism)[0]);
        CHECK_FALSE(motion.is_finite());
        CHECK_FALSE(motion.has_motion_beside);
        CHECK(motion.states.size() == 1);
    }
    // with some slack the same joints move
    Mechanism slack = test::four_bar_at(0.7, {1.0, 1.0, 1.0, 2.5});
    CHECK(followed(slack, free_motions(slack).at(0)).is_finite());
}

TEST_CASE("Three rods hold a plate for good only if it cannot move at all", "[core][freedoms]") {
    struct Line {
        const char* name;
        Mechanism mechanism;
        std::size_t null_vectors;
        bool finite;
    };
    const Vec3 x = Vec3::UnitX();
    const Vec3 y = Vec3::UnitY();
    for (const Line& line :
         {Line{
              "in general",
              test::plate_on_rods({-x, Vec3::Zero(), x}, {-x + y, 0.3 * x + 1.2 * y, 2.0 * x + y}), 0, false},
          // all lines through (0, 3, 0)
          Line{
              "through one point",
              test::plate_on_rods(
                  {-x, 0.1 * x - 0.6 * y, x},
                  {0.5 * (3.0 * y - x), y + 0.1 * x * 2.0 / 3.6, 0.2 * (3.0 * y) + 0.8 * x}),
              1, false},
          Line{
              "parallel and equal", test::plate_on_rods({-x, 0.2 * x, x}, {y - x, y + 0.2 * x, y + x}), 1,
              true},
          Line{
              "parallel, not equal", test::plate_on_rods({-x, 0.2 * x, x}, {y - x, 1.5 * y + 0.2 * x, y + x}),
              1, false}}) {
        CAPTURE(line.name);
        const std::vector<FreeMotion> motions = free_motions(line.mechanism);
        REQUIRE(motions.size() == line.null_vectors);
        for (const FreeMotion& free : motions) {
            CHECK(followed(line.mechanism, free).is_finite() == line.finite);
            CHECK(followed(line.mechanism, -3.0 * free).is_finite() == line.finite);
        }
    }
}

TEST_CASE("Both freedoms of an RSSR loop are finite, the idle spin of its rod as well", "[core][freedoms]") {
    const Mechanism mechanism = test::rssr(0.7);
    const std::vector<FreeMotion> motions = free_motions(mechanism);
    REQUIRE(motions.size() == 2);
    int idle = 0;
    for (const FreeMotion& free : motions) {
        const FollowedMotion motion = followed(mechanism, free, 20);
        CHECK(motion.is_finite());
        CHECK(motion.states.size() == 41);
        const bool spins = free.segment<3>(3).norm() < 1e-9 && free.segment<3>(15).norm() < 1e-9;
        if (!spins) { continue; }
        ++idle;
        // the rod turns by 0.1 rad per step and its ends stay
        const double turn = turn_local_between(motion.states[20].p[2], motion.states[40].p[2]).norm();
        CHECK(turn == Approx(2.0).epsilon(1e-9));
        CHECK((motion.states[0].r[2] - motion.states[40].r[2]).norm() < 1e-12);
    }
    CHECK(idle == 1);
}

TEST_CASE("Bennett's loop moves although counting says it cannot", "[core][freedoms]") {
    const Mechanism mechanism = test::bennett(1.1);
    CHECK(test::rank_of(mechanism).mobility_by_counting < 0);
    const FollowedMotion motion = followed(mechanism, free_motions(mechanism).at(0), 12);
    CHECK(motion.is_finite());
    REQUIRE(motion.states.size() == 25);
    const test::Bennett lengths;
    for (const State& state : motion.states) {
        const double product = std::tan(0.5 * relative_angle(mechanism.joints[0], state)) *
                               std::tan(0.5 * relative_angle(mechanism.joints[1], state));
        CHECK(product == Approx(lengths.half_tangents()).epsilon(1e-10));
    }
}

TEST_CASE("At its change point a parallelogram has two branches, each finite", "[core][freedoms]") {
    const Mechanism mechanism = test::parallelogram(0.0);
    // second order of the closure: φ₁² + 2 φ_c² = φ₃² with φ_c = (φ₃ - φ₁)/2 gives φ₃ = φ₁ and φ₃ = -3 φ₁
    struct Line {
        double rocker;
        bool parallel;
    };
    for (const Line& line : {Line{1.0, true}, Line{-3.0, false}}) {
        CAPTURE(line.rocker);
        const FollowedMotion motion = followed(mechanism, parallelogram_motion(1.0, line.rocker));
        CHECK(motion.is_finite());
        CHECK(motion.states.size() == 17);
        for (const State& state : motion.states) {
            const double crank = relative_angle(mechanism.joints[0], state);
            const double rocker = relative_angle(mechanism.joints[3], state);
            const bool together = std::abs(crank - rocker) < 1e-9;
            CHECK(together == (line.parallel || std::abs(crank) < 1e-12));
        }
    }
    // directions between the two tangents are not motions; they lead onto one tangent or the other
    REQUIRE(free_motions(mechanism).size() == 2);
    const auto check_between = [&](const VectorX& direction) {
        const FollowedMotion motion = followed(mechanism, direction);
        CHECK(motion.states.size() > 1);
        REQUIRE(motion.verdict == FreedomVerdict::first_order);
        CHECK(motion.departure->order == 2);
        CHECK(motion.has_motion_beside);
    };
    for (const FreeMotion& free : free_motions(mechanism)) { check_between(free); }
    for (int k = 0; k < 12; ++k) {
        const double a = kPi * k / 12.0;
        if (k == 3) { continue; }  // the tangent (1, 1)
        CAPTURE(a);
        check_between(parallelogram_motion(std::cos(a), std::sin(a)));
    }
}

TEST_CASE(
    "A crank that cannot turn fully swings back at its dead points, and the motion goes on",
    "[core][freedoms]") {
    const Mechanism mechanism = test::four_bar_at(0.7, {1.5, 1.2, 1.5, 3.0});
    const FollowedMotion motion = followed(mechanism, free_motions(mechanism).at(0), 200);
    CHECK(motion.is_finite());
    CHECK(motion.states.size() == 401);
    int turns_back = 0;
    for (std::size_t k = 2; k < motion.states.size(); ++k) {
        const auto step = [&](std::size_t n) {
            return relative_angle(mechanism.joints[0], motion.states[n]) -
                   relative_angle(mechanism.joints[0], motion.states[n - 1]);
        };
        if (step(k) * step(k - 1) < 0.0) { ++turns_back; }
        // coupler and rocker together reach 2.7 of the 3.0 to the other bearing
        CHECK(std::cos(relative_angle(mechanism.joints[0], motion.states[k])) > 0.43);
    }
    CHECK(turns_back >= 2);
}

TEST_CASE("A step of a free motion is proved on its branch and not to the other one", "[core][freedoms]") {
    const Mechanism mechanism = test::four_bar_at(0.7);
    const System system(mechanism, everything(mechanism));
    const VectorX free = free_motions(mechanism).at(0);
    const State from = start_state(mechanism);
    const State to = follow_free_motion(system, from, 0.0, free, 1, 0.01).states.back();
    // coupler and rocker mirrored about the line between their other ends
    const Vec3 A(std::cos(0.7), std::sin(0.7), 0.0);
    const Vec3 D = 3.0 * Vec3::UnitX();
    const Vec3 B = test::circles_meet(A, 2.5, D, 2.0, 1.0);
    const Vec3 mirrored = test::circles_meet(A, 2.5, D, 2.0, -1.0);
    State other = from;
    const auto turn = [&](std::size_t body, const Vec3& before, const Vec3& after) {
        const Vec4& p = from.p[body];
        const Eigen::Quaterniond q =
            Eigen::Quaterniond::FromTwoVectors(before, after) * Eigen::Quaterniond(p(0), p(1), p(2), p(3));
        other.p[body] = Vec4(q.w(), q.x(), q.y(), q.z());
    };
    turn(2, B - A, mirrored - A);
    turn(3, B - D, mirrored - D);
    REQUIRE(largest_residual(system, other) < 1e-12);

    // both ends have the velocity of the start: accurate enough for a short step
    const Motion velocity = Layout<OmegaLocal>(system).motion_of(from, free / free.cwiseAbs().maxCoeff());
    StepProof kept(system, StepProof::LeftFree::kept);
    CHECK(kept.holds({0.0, &from, &velocity}, {0.0, &from, &velocity}));
    CHECK_FALSE(kept.holds({0.0, &from, &velocity}, {0.01, &other, &velocity}));
    CHECK_FALSE(kept.holds({0.0, &from, &velocity}, {1.0, &to, &velocity}));
    CHECK(StepProof(system).leaves_bodies_free({0.0, &from, &velocity}));
}

TEST_CASE("Free bodies, no freedom at all, and nonsense", "[core][freedoms]") {
    test::SceneBuilder scene;
    scene.add_body("free", Vec3(1.0, 2.0, 3.0));
    const std::vector<FreeMotion> motions = free_motions(scene.mechanism);
    REQUIRE(motions.size() == 6);
    for (const FreeMotion& free : motions) { CHECK(followed(scene.mechanism, free, 4).states.size() == 9); }

    const Mechanism mechanism = test::four_bar_at(0.7);
    const System system(mechanism, everything(mechanism));
    const State state = start_state(mechanism);
    CHECK_FALSE(follow_free_motion(system, state, 0.0, VectorX::Zero(18), 5, 0.1).is_finite());
    const VectorX nan = VectorX::Constant(18, std::numeric_limits<double>::quiet_NaN());
    CHECK_FALSE(follow_free_motion(system, state, 0.0, nan, 5, 0.1).is_finite());
    CHECK(follow_free_motion(system, state, 0.0, free_motions(mechanism)[0], 0, 0.1).states.size() == 1);
    CHECK_THROWS_AS(follow_free_motion(system, state, 0.0, VectorX::Ones(17), 5, 0.1), std::invalid_argument);
}
