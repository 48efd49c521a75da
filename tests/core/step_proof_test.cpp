#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "core/kinematics/kinematics.hpp"
#include "core/kinematics/proof/step_proof.hpp"
#include "core/poses/position.hpp"
#include "tests/support/driven.hpp"
#include "tests/support/driven_linkages.hpp"
#include "tests/support/moved_along.hpp"

/// Steps that a proof accepts: none to another branch, none that a driver leaves in between, and of the
/// others those that its bounds allow.
using namespace jw;
using namespace jw::test;

namespace {

struct ProvedPose {
    double t = 0.0;
    State state;
    Motion velocity;

    PathEnd end() const { return {t, &state, &velocity}; }
};

/// ProvedPose at time t near a state, with its velocity.
ProvedPose proved_pose(const System& system, const State& near, double t) {
    ProvedPose pose{t, near, {}};
    REQUIRE(solve_position<OmegaLocal>(system, pose.state, t).ok());
    Kinematics<OmegaLocal> kinematics(system);
    kinematics.set_state(pose.state, t);
    pose.state = kinematics.corrected_state();
    kinematics.set_state(pose.state, t);
    pose.velocity = kinematics.solve_velocity(zero_motion(system.mechanism())).velocity;
    return pose;
}

ProvedPose start_of(System& system, double t = 0.0) {
    const State start = start_state(system.mechanism());
    system.choose_rows(start);
    return proved_pose(system, start, t);
}

/// Longest steps that are proved [ms], from the start and from the end of the first one, to a relative
/// accuracy of 1e-3.
/// @param off  by which body 1 is off its place [m]; its velocity 300 times that [m/s]
std::array<double, 2> longest_steps(const Mechanism& mechanism, double off = 0.0) {
    System system(mechanism, everything(mechanism));
    StepProof proof(system);
    std::array<double, 2> longest{};
    ProvedPose from = start_of(system);
    const auto beyond = [&](double h) {
        const State near = moved_along(from.state, from.velocity, zero_motion(mechanism), h);
        ProvedPose pose = proved_pose(system, near, from.t + h);
        pose.state.r[1].x() += off;
        pose.velocity.r_dot[1].y() += 300.0 * off;
        return pose;
    };
    for (double& length : longest) {
        double proved = 1e-4;
        ProvedPose reached = beyond(proved);
        CHECK(proof.holds(from.end(), reached.end()));
        for (double refused = 0.3; refused > 1.0001 * proved;) {
            const double h = std::sqrt(proved * refused);
            const ProvedPose to = beyond(h);
            const bool holds = proof.holds(from.end(), to.end());
            (holds ? proved : refused) = h;
            if (holds) { reached = to; }
        }
        length = 1e3 * proved;
        from = reached;
    }
    return longest;
}

/// Turns a body about an axis through a point.
void turn_body(State& state, int body, const Vec3& point, const Vec3& axis, double angle) {
    const Eigen::AngleAxisd turned(angle, axis);
    state.r[at(body)] = point + turned * (state.r[at(body)] - point);
    state.p[at(body)] = product(euler_parameters_of(axis, angle), state.p[at(body)]);
}

double angle_about_z(const Vec3& from, const Vec3& to) {
    return std::atan2(from.cross(to).z(), from.dot(to));
}

DrivenLoop loop_of(DrivenLoop (*make)(Random&, double), unsigned seed) {
    Random random(seed);
    return make(random, 0.1);
}

/// Crank and rocker with a rod between balls, which is free to turn about itself.
Mechanism with_idle_rod() {
    SceneBuilder scene;
    const Vec3 A(0.5, 0.0, 0.0);
    const Vec3 B(1.5, 0.5, 0.8);
    const int crank = scene.add_body("crank", Vec3::Zero());
    const int rod = scene.add_body("rod", 0.5 * (A + B));
    const int rocker = scene.add_body("rocker", Vec3(1.5, -0.3, 0.1));
    scene.add_joint("revolute", 0, crank, Vec3::Zero(), Vec3::UnitZ());
    scene.add_joint("spherical", crank, rod, A, Vec3::UnitZ());
    scene.add_joint("spherical", rod, rocker, B, Vec3::UnitZ());
    scene.add_joint("revolute", 0, rocker, Vec3(1.5, -0.3, 0.1), Vec3::UnitX());
    return driven(scene.mechanism, 0, 2.0);
}

Mechanism with_driven_theta() {
    Mechanism mechanism = screw(0.7, 0.25, ScrewAngleForm::rotation);
    const double theta = start_state(mechanism).theta[0];
    mechanism.drivers.push_back({"motor", 0, 0, 1, ThetaMeasure{}, polynomial({theta, 3.0, 1.0})});
    return mechanism;
}

/// Away from `start` and back within a second, so that nothing changes at both ends.
TimeFunction there_and_back(double start, double by) {
    TimeFunction function;
    function.polynomial = {start + by};
    function.harmonics = {{by, 2.0 * std::numbers::pi, -0.5 * std::numbers::pi}};
    return function;
}

}  // namespace

TEST_CASE("A proof accepts the steps that its bounds allow and no longer ones", "[branches]") {
    // Bounds that are a tenth larger or smaller make steps a twentieth shorter or longer. The expected values
    // are those of this proof: better bounds may raise them, but wrong ones do, too.
    struct Case {
        Mechanism mechanism;
        std::array<double, 2> longest;  ///< [ms]
    };
    const Case& c = GENERATE(values<Case>(
        {{with_idle_rod(), {66.86, 126.9}},
         {with_driven_theta(), {66.34, 64.8}},
         {four_bar_of({}, {0.99, 2.0, 1.0, 2.0}, 0.01, -0.1, 1.0, 1.0).mechanism, {12.88, 6.207}},
         {loop_of(driven_slider_crank, 2).mechanism, {31.56, 40.22}},
         {loop_of(driven_spatial_loop, 3).mechanism, {31.56, 31.56}},
         {loop_of(driven_spatial_loop, 4).mechanism, {27.85, 31.56}},
         {loop_of(driven_row, 5).mechanism, {9.033, 11.6}},
         {loop_of(driven_spherical_loop, 6).mechanism, {19.14, 31.56}},
         {loop_of(driven_coupler_point, 7).mechanism, {19.74, 20.37}},
         {loop_of(bent_universal_joint, 8).mechanism, {59, 71.17}},
         {driven(screw(0.7, 0.25, ScrewAngleForm::rotation), 0, 3.0, 1.0), {53.71, 66.86}}}));
    const std::array<double, 2> longest = longest_steps(c.mechanism);
    CAPTURE(c.mechanism.bodies.size(), longest[0], longest[1]);
    CHECK(longest[0] == Approx(c.longest[0]).epsilon(1e-3));
    CHECK(longest[1] == Approx(c.longest[1]).epsilon(1e-3));
}

TEST_CASE("Poses and velocities that are off make steps shorter that can be proved", "[branches]") {
    const Mechanism four_bar = four_bar_of({}, {0.99, 2.0, 1.0, 2.0}, 0.01, -0.1, 1.0, 1.0).mechanism;
    const std::array<double, 2> longest = longest_steps(four_bar, 1e-4);
    CHECK(longest[0] == Approx(11.245).epsilon(1e-3));
    CHECK(longest[1] == Approx(5.477).epsilon(1e-3));
}

TEST_CASE("Both signs of Euler parameters are one pose for a proof", "[branches]") {
    const Mechanism mechanism = loop_of(driven_four_bar, 1).mechanism;
    System system(mechanism, everything(mechanism));
    StepProof proof(system);
    const ProvedPose one = start_of(system);
    ProvedPose two = proved_pose(system, one.state, 0.01);
    for (Vec4& p : two.state.p) { p = -p; }
    const ProvedPose three = proved_pose(system, one.state, 0.02);
    CHECK(proof.holds(one.end(), two.end()));
    CHECK(proof.holds(two.end(), three.end()));
}

TEST_CASE("A pose is decided as near to a change point as rounding allows", "[branches]") {
    // ten sizes away from the origin, a distance that sets the rounding of the numbers
    const Place place{Vec3(-6.0, 5.0, 6.0), Mat3::Identity(), 1.0};
    const auto ask = [&](double angle) {
        const DrivenLoop loop = driven_parallelogram(place, 2.0, angle, false);
        const System system(loop.mechanism, everything(loop.mechanism));
        StepProof proof(system);
        const ProvedPose pose{0.0, start_state(loop.mechanism), zero_motion(loop.mechanism)};
        const bool is_decided = proof.decides_at(pose.end());
        return std::pair(is_decided, proof.margin());
    };
    double hidden = 1e-9;
    double decided = 0.1;
    CHECK(ask(decided).first);
    CHECK(ask(decided).second == Approx(0.010367).epsilon(1e-3));
    while (decided > 1.01 * hidden) {
        const double angle = std::sqrt(hidden * decided);
        (ask(angle).first ? decided : hidden) = angle;
    }
    // the actual rounding is a tenth of what is allowed for
    CHECK(decided == Approx(2.21e-6).epsilon(0.05));
}

TEST_CASE("Bodies that the drivers together leave free are reported", "[branches]") {
    const auto leaves_free = [](const Mechanism& mechanism) {
        System system(mechanism, everything(mechanism));
        StepProof proof(system);
        return proof.leaves_bodies_free(start_of(system).end());
    };
    CHECK_FALSE(leaves_free(with_idle_rod()));
    Mechanism undriven = with_idle_rod();
    undriven.drivers.clear();
    CHECK(leaves_free(undriven));
}

TEST_CASE("Of a part that is too large it is asked that poses follow the velocities", "[branches]") {
    SceneBuilder scene;
    for (int k = 1; k <= 41; ++k) {
        const int body = scene.add_body("link", Vec3(k, 1.0, 0.0));
        if (k > 1) { scene.add_joint("spherical", body - 1, body, Vec3(k - 0.5, 1.0, 0.0), Vec3::UnitZ()); }
    }
    const System system(scene.mechanism, everything(scene.mechanism));
    StepProof proof(system);
    ProvedPose from{0.0, start_state(scene.mechanism), zero_motion(scene.mechanism)};
    for (const int body : system.moving_bodies()) { from.velocity.r_dot[at(body)] = Vec3(1.0, 2.0, 0.0); }
    const auto holds_after = [&](double way) {
        ProvedPose to = from;
        to.t = 0.1;
        for (const int body : system.moving_bodies()) {
            to.state.r[at(body)] += way * 0.1 * Vec3(1.0, 2.0, 0.0);
        }
        return proof.holds(from.end(), to.end());
    };
    // the way may differ from its tangents by 0.3 of itself
    CHECK(holds_after(1.4));
    CHECK_FALSE(holds_after(1.45));
    CHECK(holds_after(0.78));
    CHECK_FALSE(holds_after(0.76));
}

TEST_CASE("No step leads to another branch however near it comes or short the step is", "[branches]") {
    for (const double gap : {1e-1, 1e-3, 1e-5, 1e-7}) {
        const DrivenLoop loop = four_bar_of({}, {1.0 - gap, 2.0, 1.0, 2.0}, gap, -0.5, 1.0, 1.0);
        const System system(loop.mechanism, everything(loop.mechanism));
        StepProof proof(system);
        for (const double h : {0.2, 1e-2, 1e-4, 1e-6, 1e-9}) {
            CAPTURE(gap, h);
            // around the crank's position in line with the ground
            const ProvedPose from =
                proved_pose(system, start_state(loop.mechanism), 0.25 / std::numbers::pi - 0.5 * h);
            const ProvedPose to = proved_pose(system, from.state, from.t + h);
            // mirrored about the line from crank pin to pivot
            const Vec3 pin =
                (1.0 - gap) * Vec3(std::cos(std::numbers::pi * h), std::sin(std::numbers::pi * h), 0);
            const Vec3 pivot(2.0, 0.0, 0.0);
            const Vec3 meeting = loop.expected(to.t);
            State other = to.state;
            turn_body(other, 3, pivot, Vec3::UnitZ(), 2.0 * angle_about_z(meeting - pivot, pin - pivot));
            turn_body(other, 2, pin, Vec3::UnitZ(), 2.0 * angle_about_z(meeting - pin, pivot - pin));
            CHECK_FALSE(proof.holds(from.end(), proved_pose(system, other, to.t).end()));
            if (h < gap) { CHECK(proof.holds(from.end(), to.end())); }
        }
    }
}

TEST_CASE("A step whose driver comes back to where it began is not taken for one at rest", "[branches]") {
    SceneBuilder angle;
    angle.add_joint("revolute", 0, angle.add_body("crank", Vec3(0.3, 0.1, 0)), Vec3::Zero(), Vec3::UnitZ());
    SceneBuilder slide;
    slide.add_joint("prismatic", 0, slide.add_body("slide", Vec3(0.3, 0.1, 0)), Vec3::Zero(), Vec3::UnitX());
    for (const Mechanism& scene :
         {angle.mechanism, slide.mechanism, screw(0.7, 0.25, ScrewAngleForm::rotation)}) {
        const auto holds_with = [&](double by) {
            Mechanism mechanism = scene;
            const Joint& joint = mechanism.joints[0];
            const bool slides = joint.type->name == "prismatic";
            const auto measure = slides ? Measure(displacement_of(joint)) : Measure(angle_of(joint));
            mechanism.drivers.push_back({"motor", 0, 0, 1, measure, {}});
            const double start = slides ? 0.0 : relative_angle(joint, start_state(mechanism));
            mechanism.drivers[0].function = there_and_back(start, by);
            System system(mechanism, everything(mechanism));
            StepProof proof(system);
            const ProvedPose from = start_of(system);
            const ProvedPose to = proved_pose(system, from.state, 1.0);
            CHECK(from.velocity.r_dot[1].norm() + to.velocity.r_dot[1].norm() < 1e-12);
            return proof.holds(from.end(), to.end());
        };
        CAPTURE(scene.joints[0].type->name);
        CHECK(holds_with(1e-6));
        CHECK_FALSE(holds_with(0.1));
    }
}
