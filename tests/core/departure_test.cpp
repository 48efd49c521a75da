#include <cmath>

#include <catch2/catch.hpp>

#include "core/kinematics/freedoms.hpp"
#include "core/poses/position.hpp"
#include "tests/support/driven.hpp"
#include "tests/support/random_mechanisms.hpp"
#include "tests/support/singular_scenes.hpp"

/// Free motions that are finite, and the orders at which others leave the equations, against closed forms.
using namespace jw;
using namespace jw::test;

namespace {

FollowedMotion followed_from(const Mechanism& mechanism, const State& state, const VectorX& direction) {
    System system(mechanism, everything(mechanism));
    system.choose_rows(state);
    return follow_free_motion(system, state, 0.0, direction, 24, 0.03);
}

/// The only free motion of a mechanism.
FollowedMotion followed(const Mechanism& mechanism) {
    const auto motions = rank_of(mechanism).free_motions;
    REQUIRE(motions.size() == 1);
    return followed_from(mechanism, start_state(mechanism), motions[0]);
}

void check_order(const FollowedMotion& motion, int order, double coefficient) {
    CHECK(motion.verdict == FreedomVerdict::first_order);
    REQUIRE(motion.departure);
    CHECK(motion.departure->order == order);
    CHECK(motion.departure->coefficient == Approx(coefficient).epsilon(1e-9));
}

/// Watt's linkage with bars of length `size`, its midpoint on a line along y.
Mechanism watt(double size, double turn = 0.0) {
    SceneBuilder scene;
    const Mat3 A = Eigen::AngleAxisd(turn, Vec3(1.0, 2.0, 2.0).normalized()).toRotationMatrix();
    const auto at = [&](double x, double y) { return Vec3(size * (A * Vec3(x, y, 0.0))); };
    const int left = scene.add_body("left", at(-0.5, 0.2));
    const int middle = scene.add_body("middle", Vec3::Zero());
    const int right = scene.add_body("right", at(0.5, -0.2));
    const Vec3 z = A.col(2);
    scene.add_joint("revolute", 0, left, at(-1.0, 0.2), z);
    scene.add_joint("revolute", left, middle, at(0.0, 0.2), z);
    scene.add_joint("revolute", middle, right, at(0.0, -0.2), z);
    scene.add_joint("revolute", 0, right, at(1.0, -0.2), z);
    scene.add_joint("point-on-line", 0, middle, Vec3::Zero(), A.col(1));
    return scene.mechanism;
}

/// Two of Watt's linkages, one of them mirrored, whose midpoints a bar keeps apart: 12.5 y⁵ = -(y₁ - y₂)², a
/// cusp.
Mechanism double_watt() {
    SceneBuilder scene;
    for (const double x : {0.0, 5.0}) {
        const double side = x == 0.0 ? 0.2 : -0.2;
        const int left = scene.add_body("left", Vec3(x - 0.5, side, 0.0));
        const int middle = scene.add_body("middle", Vec3(x, 0.0, 0.0));
        const int right = scene.add_body("right", Vec3(x + 0.5, -side, 0.0));
        const Vec3 z = Vec3::UnitZ();
        scene.add_joint("revolute", 0, left, Vec3(x - 1.0, side, 0.0), z);
        scene.add_joint("revolute", left, middle, Vec3(x, side, 0.0), z);
        scene.add_joint("revolute", middle, right, Vec3(x, -side, 0.0), z);
        scene.add_joint("revolute", 0, right, Vec3(x + 1.0, -side, 0.0), z);
    }
    scene.add_distance(2, 5, Vec3::Zero(), Vec3(5.0, 0.0, 0.0));
    return scene.mechanism;
}

/// Rod with two points on perpendicular lines: its end runs on an ellipse with half axes a and b, and is held
/// on the circle that osculates at (a, 0), of radius b²/a.
Mechanism trammel(double a, double b) {
    SceneBuilder scene;
    const Vec3 x = Vec3::UnitX();
    const int rod = scene.add_body("rod", a * x);
    scene.add_joint("planar", 0, rod, Vec3::Zero(), Vec3::UnitZ());
    scene.add_joint("point-on-line", 0, rod, Vec3::Zero(), Vec3::UnitY());
    scene.add_joint("point-on-line", 0, rod, (a - b) * x, x);
    scene.add_distance(0, rod, (a - b * b / a) * x, a * x);
    return scene.mechanism;
}

/// Wheel of radius 1 whose point is held on a tangent, or on the tangent's circle of another radius.
Mechanism touching(double radius) {
    SceneBuilder scene;
    const int wheel = scene.add_body("wheel", Vec3::Zero());
    const Vec3 x = Vec3::UnitX();
    scene.add_joint("revolute", 0, wheel, Vec3::Zero(), Vec3::UnitZ());
    scene.add_distance(0, wheel, (1.0 - radius) * x, x);
    return scene.mechanism;
}

/// Plate that two pairs of folding plates guide along z, in two planes.
Mechanism sarrus(double height) {
    SceneBuilder scene;
    const int top = scene.add_body("top", Vec3(0.0, 0.0, height));
    const double out = std::sqrt(1.0 - 0.25 * height * height);
    for (const Vec3& side : {Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0)}) {
        const Vec3 axis = side.cross(Vec3::UnitZ());
        const Vec3 knee = (0.5 + out) * side + Vec3(0.0, 0.0, 0.5 * height);
        const int lower = scene.add_body("lower", 0.5 * (0.5 * side + knee));
        const int upper = scene.add_body("upper", knee);
        scene.add_joint("revolute", 0, lower, 0.5 * side, axis);
        scene.add_joint("revolute", lower, upper, knee, axis);
        scene.add_joint("revolute", upper, top, 0.5 * side + Vec3(0.0, 0.0, height), axis);
    }
    return scene.mechanism;
}

}  // namespace

TEST_CASE(
    "Watt's linkage leaves its line by 0.625 y⁵, wherever it is and however large", "[core][freedoms]") {
    check_order(followed(watt(1.0)), 5, 0.625);
    const FollowedMotion motion = followed(watt(1.0));
    CHECK(motion.departure->joint == 4);
    CHECK(motion.departure->body == 2);
    CHECK(motion.departure->direction == 1);
    CHECK(motion.states.size() > 1);  // Newton's method does not notice the departure at first
    CHECK_FALSE(motion.has_motion_beside);
    check_order(followed(watt(1e-3)), 5, 0.625e12);
    check_order(followed(watt(1e3)), 5, 0.625e-12);
    // y is measured along the largest component of the line
    const Mat3 A = Eigen::AngleAxisd(0.9, Vec3(1.0, 2.0, 2.0).normalized()).toRotationMatrix();
    check_order(followed(watt(1.0, 0.9)), 5, 0.625 / std::pow(A.col(1).cwiseAbs().maxCoeff(), 5.0));
}

TEST_CASE("A pose that Newton's method has found leaves at the same order", "[core][freedoms]") {
    Mechanism mechanism = watt(1.0);
    System system(mechanism, everything(mechanism));
    State state = start_state(mechanism);
    const double y = 1e-3;
    state.r[2] += y * Vec3::UnitY();
    state.r[1] += 0.5 * y * Vec3::UnitY();
    state.r[3] += 0.5 * y * Vec3::UnitY();
    state.p[1] = turned_local(state.p[1], y * Vec3::UnitZ());
    state.p[3] = turned_local(state.p[3], -y * Vec3::UnitZ());
    REQUIRE(solve_position<OmegaLocal>(system, state, 0.0).ok());
    REQUIRE(std::abs(state.r[2].y()) > 0.5 * y);
    for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
        mechanism.bodies[b].r = state.r[b];
        mechanism.bodies[b].p = state.p[b];
    }
    const FollowedMotion motion = followed(mechanism);
    CHECK(motion.verdict == FreedomVerdict::first_order);
    REQUIRE(motion.departure);
    CHECK(motion.departure->order == 5);
    CHECK(motion.departure->coefficient == Approx(0.625).epsilon(1e-2));
}

TEST_CASE("Orders and coefficients of velocities that are no motions", "[core][freedoms]") {
    // the gap 2 - 2 cos φ
    check_order(followed(stretched_bars()), 2, 1.0);
    check_order(followed(stretched_revolutes()), 2, 1.0);
    // d² - R² with the centre at c = 1 - R: 2 c (1 - cos φ)
    for (const double radius : {0.5, 3.0, 100.0}) {
        CAPTURE(radius);
        check_order(followed(touching(radius)), 2, std::abs(1.0 - radius));
    }
    // (a² - b²) (1 - cos φ)²
    check_order(followed(trammel(2.0, 0.8)), 4, (4.0 - 0.64) / 4.0);
    check_order(followed(trammel(1.0, 0.99)), 4, (1.0 - 0.9801) / 4.0);
}

TEST_CASE("Where the curve is the circle itself the motion is finite", "[core][freedoms]") {
    CHECK(followed(touching(1.0)).verdict == FreedomVerdict::finite);
    // Cardan's circles
    CHECK(followed(trammel(-1.0, 1.0)).verdict == FreedomVerdict::finite);
}

TEST_CASE("A freedom beside it does not hide that a linkage is locked", "[core][freedoms]") {
    // a disk that spins on the middle bar, and a free body
    Mechanism mechanism = watt(1.0);
    SceneBuilder scene;
    scene.mechanism = mechanism;
    const int disk = scene.add_body("disk", Vec3(0.1, 0.3, 0.0));
    scene.add_joint("revolute", 2, disk, Vec3(0.0, 0.3, 0.0), Vec3::UnitY());
    scene.add_body("free", Vec3(3.0, 0.0, 0.0));
    int locked = 0;
    int finite = 0;
    for (const FreeMotion& free : rank_of(scene.mechanism).free_motions) {
        const FollowedMotion motion = followed_from(scene.mechanism, start_state(scene.mechanism), free);
        if (motion.is_finite()) {
            ++finite;
        } else {
            check_order(motion, 5, 0.625);
            ++locked;
        }
    }
    CHECK(locked == 1);
    CHECK(finite == 7);
}

TEST_CASE("A cusp is not told locked, and what leaves it at once is", "[core][freedoms]") {
    const Mechanism mechanism = double_watt();
    const auto motions = rank_of(mechanism).free_motions;
    REQUIRE(motions.size() == 2);
    const State start = start_state(mechanism);
    VectorX both = VectorX::Zero(motions[0].size());
    for (const FreeMotion& free : motions) {
        // y of the two midpoints; one of them stands still
        both += free / (free(7) + free(25));
        check_order(followed_from(mechanism, start, free), 2, 1.0);
    }
    CHECK(followed_from(mechanism, start, both).verdict == FreedomVerdict::cannot_tell);
}

TEST_CASE("Four-bars driven out and overconstrained classics are finite", "[core][freedoms]") {
    Random random(17);
    for (int n = 0; n < 20; ++n) {
        CAPTURE(n);
        const double angle = random.number(0.3, 6.0);
        const FourBarLengths lengths{
            random.number(0.3, 0.9), random.number(2.0, 2.4), random.number(1.8, 2.4),
            random.number(2.2, 2.6)};
        CHECK(followed(four_bar_at(angle, lengths)).verdict == FreedomVerdict::finite);
    }
    for (const double angle : {0.4, 1.1, 2.5}) {
        CHECK(followed(bennett(angle)).verdict == FreedomVerdict::finite);
    }
    CHECK(followed(bricard(1.2)).verdict == FreedomVerdict::finite);
    CHECK(followed(sarrus(1.2)).verdict == FreedomVerdict::finite);
    CHECK(followed(parallelogram(0.7)).verdict == FreedomVerdict::finite);
    // arms that stand along the shafts: input free, output at its slowest
    CHECK(followed(cardan(radians(60.0), 0.5 * kPi)).verdict == FreedomVerdict::finite);
}

TEST_CASE("A linkage that is typed with eight digits is followed, and not told finite", "[core][freedoms]") {
    Mechanism mechanism = bennett(1.1);
    for (Joint& joint : mechanism.joints) {
        for (Vec3* v : {&joint.geometry.s_i_local, &joint.geometry.s_j_local}) {
            for (double& x : *v) { x = std::round(1e8 * x) / 1e8; }
        }
    }
    const FollowedMotion motion = followed(mechanism);
    CHECK(motion.states.size() == 49);
    CHECK(motion.verdict == FreedomVerdict::cannot_tell);
}

TEST_CASE("A motion that is followed less far than it must be proved is not told", "[core][freedoms]") {
    const Mechanism mechanism = four_bar_at(0.7);
    const System system(mechanism, everything(mechanism));
    const VectorX free = rank_of(mechanism).free_motions.at(0);
    const State start = start_state(mechanism);
    CHECK(follow_free_motion(system, start, 0.0, free, 3, 0.05).verdict == FreedomVerdict::cannot_tell);
    CHECK(follow_free_motion(system, start, 0.0, free, 4, 0.05).verdict == FreedomVerdict::finite);
}
