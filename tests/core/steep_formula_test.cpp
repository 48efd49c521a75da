#include <array>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "core/kinematics/motion_tracker.hpp"
#include "core/poses/branches.hpp"
#include "tests/support/driven.hpp"
#include "tests/support/scene_builder.hpp"

/// Motions with an equation of an author whose gradient changes by many powers of ten.
namespace jw::test {

using namespace authored;
using enum FormulaVector;

namespace {

/// A crank 1 - margin and a rocker 1, pivots 2 apart, with a rod of length 2 between their ends: the last
/// joint. The crank turns once in a second.
Mechanism driven_rod(double margin) {
    SceneBuilder scene;
    const double length = 1.0 - margin;
    const Vec3 crank_pin(0.0, length, 0.0);
    // where circles of radius 2 about the pin of the crank and of radius 1 about (2, 0) meet above the axis
    const Vec3 line = Vec3(2.0, 0.0, 0.0) - crank_pin;
    const double apart = line.norm();
    const double along = (apart * apart + 4.0 - 1.0) / (2.0 * apart);
    const Vec3 unit = line / apart;
    const Vec3 rocker_pin =
        crank_pin + along * unit + std::sqrt(4.0 - along * along) * Vec3::UnitZ().cross(unit);
    const int crank = scene.add_body("crank", 0.5 * crank_pin);
    const int rocker = scene.add_body("rocker", rocker_pin);
    scene.add_joint("revolute", 0, crank, Vec3::Zero(), Vec3::UnitZ());
    scene.add_joint("revolute", 0, rocker, Vec3(2.0, 0.0, 0.0), Vec3::UnitZ());
    scene.add_distance(crank, rocker, crank_pin, rocker_pin);
    drive_angle(scene.mechanism, 0, polynomial({0.0, 2.0 * std::numbers::pi}));
    return scene.mechanism;
}

}  // namespace

TEST_CASE(
    "A rod that is a steep formula moves as the rod does, proved also near folding",
    "[core][formula_joint]") {
    const double margin = GENERATE(0.1, 1e-5);
    const auto exponential = [](const Part& a) {
        return of_one("\\exp(" + a.text + ")", a, {FormulaStep::Kind::exponential, 0.0});
    };
    const Part quarter = number(0.25) * dot(d, d);
    const Part excess = dot(d, d) - number(4.0);
    const std::array equal_to_1{
        power(quarter, 1.0), power(quarter, 8.0), power(quarter, 50.0), exponential(number(2.0) * excess),
        exponential(number(10.0) * excess)};
    const Part& left = equal_to_1[GENERATE(range(0U, 5U))];
    const int steps = GENERATE(3, 36);
    CAPTURE(margin, left.text, steps);
    const Mechanism rod = driven_rod(margin);
    Mechanism steep = rod;
    steep.joints[2].type = find_joint_type("formula");
    steep.joints[2].geometry.formula = equation(left, 1.0);
    System system(rod, everything(rod));
    System steep_system(steep, everything(steep));
    MotionTracker tracker(system, start_state(rod), 0.0);
    MotionTracker steep_tracker(steep_system, start_state(steep), 0.0);
    for (int k = 1; k <= steps; ++k) {
        REQUIRE(tracker.advance_to(static_cast<double>(k) / steps));
        REQUIRE(steep_tracker.advance_to(static_cast<double>(k) / steps));
        CHECK(steep_tracker.frame().change_point == tracker.frame().change_point);
        // rounding divided by the margin of the pose
        CHECK(movement(system, tracker.frame().state, steep_tracker.frame().state) < 1e-9);
    }
    CHECK(steep_tracker.crossings().empty());
}

}  // namespace jw::test
