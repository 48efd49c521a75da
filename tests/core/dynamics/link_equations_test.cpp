#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "core/equations/assembler.hpp"
#include "core/equations/link_equations.hpp"
#include "core/jets/body_kinematics.hpp"
#include "tests/support/moved_along.hpp"
#include "tests/support/random_mechanisms.hpp"

using namespace jw;

namespace {

using Columns = Eigen::Matrix<double, 6, 1>;

struct Rows {
    VectorX value;
    VectorX first;   ///< Jacobian times velocities, or rate, less the rate of a driver's function
    VectorX second;  ///< Jacobian times accelerations, or bias less the second derivative of the function
};

Columns columns_of(const Motion& motion, int body) {
    Columns columns;
    columns << motion.r_dot[static_cast<std::size_t>(body)],
        motion.omega_local[static_cast<std::size_t>(body)];
    return columns;
}

struct Scene {
    Mechanism mechanism;
    State state;
    Motion velocity;
    Motion acceleration;

    BodyKinematics<OmegaLocal> body(int index, const State& at) const {
        const auto b = static_cast<std::size_t>(index);
        return kinematics_at<OmegaLocal>(at.r[b], at.p[b], velocity.r_dot[b], velocity.omega_local[b]);
    }

    Rows by_jacobian(const Link& link, const LinkPrimitive& primitive, const State& at, double t) const {
        Rows rows;
        visit_rows<Content::jacobian>(
            primitive, body(link.body_i, at), body(link.body_j, at), t,
            [&](const auto& jet, double f_dot, double f_ddot) {
                using J = std::decay_t<decltype(jet)>;
                rows = {jet.value, VectorX::Constant(J::kDim, -f_dot), VectorX::Constant(J::kDim, -f_ddot)};
                const auto add = [&](const auto& block, int index) {
                    rows.first += block * columns_of(velocity, index);
                    rows.second += block * columns_of(acceleration, index);
                };
                if constexpr ((J::kSides & kBodyI) != 0) { add(jet.block_i, link.body_i); }
                if constexpr ((J::kSides & kBodyJ) != 0) { add(jet.block_j, link.body_j); }
            });
        return rows;
    }

    Rows by_motion(const Link& link, const LinkPrimitive& primitive, double t) const {
        Rows rows;
        visit_rows<Content::motion>(
            primitive, body(link.body_i, state), body(link.body_j, state), t,
            [&](const auto& jet, double f_dot, double) {
                rows = {jet.value, jet.rate.array() - f_dot, jet.bias};
            });
        return rows;
    }
};

Scene moving(test::Random& random, Mechanism mechanism) {
    Scene scene{std::move(mechanism), {}, {}, {}};
    scene.state = start_state(scene.mechanism);
    scene.velocity = start_motion(scene.mechanism);
    scene.acceleration = zero_motion(scene.mechanism);
    for (Vec3& r_ddot : scene.acceleration.r_dot) { r_ddot = random.vector(); }
    for (Vec3& omega_dot : scene.acceleration.omega_local) { omega_dot = random.vector(); }
    return scene;
}

/// A primitive whose turns are counted from the scene's pose on.
LinkPrimitive counted(const Scene& scene, const Link& link, LinkPrimitive primitive, double t) {
    tell_turns(
        primitive, Turns::of_start, t, scene.body(link.body_i, scene.state),
        scene.body(link.body_j, scene.state));
    // the directions across a curve are exact up to a turn about it: on the curve that does not matter
    if (auto* on = std::get_if<CurveFollowed>(&primitive)) {
        const Vec3 d =
            d_local_of(*on, scene.body(link.body_i, scene.state), scene.body(link.body_j, scene.state));
        on->curve.constant += d - on->curve.at(on->so_far->theta).c;
        tell_turns(
            primitive, Turns::of_start, t, scene.body(link.body_i, scene.state),
            scene.body(link.body_j, scene.state));
    }
    return primitive;
}

void check_against_differences(const Scene& scene) {
    const double t0 = 0.3;
    for (const Link& link : links_of(scene.mechanism)) {
        for (const LinkEquation& equation : link.equations) {
            CAPTURE(link.joint, link.driver, equation.first_row);
            const LinkPrimitive primitive = counted(scene, link, equation.primitive, t0);
            const Rows rows = scene.by_jacobian(link, primitive, scene.state, t0);
            const auto value = [&](double t) {
                const State at = test::moved_along(scene.state, scene.velocity, scene.acceleration, t);
                return scene.by_jacobian(link, primitive, at, t0 + t).value;
            };
            const Rows motion = scene.by_motion(link, primitive, t0);
            // functions grow to some ten in a second
            const double rate_error = 100.0 * test::kRateError;
            const double error = 100.0 * test::kAccelerationError;
            // angles of wheels near their line have larger derivatives: with a shorter step rounding is 1e-8;
            // those of curves are larger still
            const bool is_curve = std::holds_alternative<CurveFollowed>(primitive);
            const double h = is_curve ? 1.25e-4 : counts_turns(primitive) ? 5e-4 : 2e-3;
            CHECK((rows.first - test::rate_by_difference(value, 0.5 * h)).norm() < rate_error);
            CHECK((motion.first - test::rate_by_difference(value, 0.5 * h)).norm() < rate_error);
            CHECK((rows.second + motion.second - test::acceleration_by_difference(value, h)).norm() < error);
            CHECK((rows.value - motion.value).norm() == 0.0);
        }
    }
}

}  // namespace

TEST_CASE(
    "Jacobian, rate and bias of the rows of every link are differences of their values", "[core][dynamics]") {
    for (unsigned seed = 1; seed <= 3; ++seed) {
        test::Random random(seed);
        CAPTURE(seed);
        for (const ParallelForm form : {ParallelForm::rule, ParallelForm::drop_y}) {
            for (const JointType& type : kJointTypes) {
                CAPTURE(type.name);
                check_against_differences(
                    moving(random, test::random_joint(random, type, form, ScrewAngleForm::rotation)));
            }
        }
        check_against_differences(moving(random, test::random_drivers(random)));
    }
}

TEST_CASE("A screw without θ is as far off as with it, but for whole turns", "[core][dynamics]") {
    for (unsigned seed = 1; seed <= 10; ++seed) {
        test::Random random(seed);
        const Mechanism mechanism = test::random_joint(
            random, *find_joint_type("screw"), ParallelForm::rule, ScrewAngleForm::rotation);
        const Scene scene = moving(random, mechanism);  // θ is the angle between the bodies
        const System system(mechanism, everything(mechanism));
        double with_theta = 0.0;
        for (const Constraint& c : system.constraints()) {
            if (c.role == Role::screw_advance) { with_theta = values_of(c, scene.state)(0); }
        }
        const double turn = 2.0 * std::numbers::pi * std::abs(mechanism.joints[0].geometry.alpha);
        CAPTURE(seed, with_theta, turn);
        bool found = false;
        for (const Link& link : links_of(mechanism)) {
            for (const LinkEquation& equation : link.equations) {
                if (!std::holds_alternative<ScrewTurned>(equation.primitive)) { continue; }
                found = true;
                const double value = scene.by_jacobian(link, equation.primitive, scene.state, 0.0).value(0);
                CHECK(std::abs(std::remainder(value - with_theta, turn)) < 1e-14);  // rounding
                CHECK(std::abs(value) <= 0.5 * turn + 1e-14);
            }
        }
        CHECK(found);
    }
}

TEST_CASE("A screw is followed by its rate through turns that no pose tells", "[core][dynamics]") {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        test::Random random(seed);
        CAPTURE(seed);
        const double theta = random.number(-60.0, 60.0);
        const double rate = random.number(10.0, 30.0);
        const double before = random.number(0.0, 1.0);
        const double now = before + random.number(1.0, 2.0);
        ScrewTurned screw{{}, {}, random.number(0.1, 0.5), random.number(), random.number()};
        // several turns later, and up to 2 rad from the angle that the rate predicts
        screw.so_far = TurnsSoFar{before, theta - rate * (now - before) + random.number(-2.0, 2.0), rate};
        const double off = random.number(-0.1, 0.1);
        const double advanced = screw.d_0 + screw.alpha * (theta - screw.theta_0) + off;
        const double turned = std::remainder(theta, 2.0 * std::numbers::pi);
        // rounding of 60 rad times an advance of 0.5 m/rad
        CHECK(std::abs(screw.residual(advanced, turned, now) - off) < 1e-13);
        CHECK(std::abs(screw.theta_of(advanced - off) - theta) < 1e-11);
    }
}

TEST_CASE("A gear is followed by its rate through turns that no pose tells", "[core][dynamics]") {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        test::Random random(seed);
        CAPTURE(seed);
        constexpr double turn = 2.0 * std::numbers::pi;
        const double theta = random.number(-60.0, 60.0);
        const double rate = random.number(10.0, 30.0);
        const double before = random.number(0.0, 1.0);
        const double now = before + random.number(1.0, 2.0);
        GearTurned gear{};
        gear.j.ratio = random.number(-3.0, 3.0);
        gear.so_far = TurnsSoFar{before, theta - rate * (now - before) + random.number(-2.0, 2.0), rate};
        const double off = random.number(-0.1, 0.1);
        const double turned_i = std::remainder(theta, turn);
        const double turned_j = std::remainder(gear.j.ratio * theta + off, turn);
        // rounding of 180 rad
        CHECK(std::abs(gear.residual(turned_i, turned_j, now) - off) < 1e-12);
        // without a history, a few turns of a wheel with teeth can still be found
        gear.so_far.reset();
        gear.j.ratio = -7.0 / 11.0;
        const double few = random.number(-4.0, 4.0) * turn;
        const double small = 0.01 * off;
        CHECK(
            std::abs(
                gear.residual(
                    std::remainder(few, turn), std::remainder(gear.j.ratio * few + small, turn), now) -
                small) < 1e-12);
    }
}

TEST_CASE(
    "A point on a wire is followed by its rate, across directions that do not turn", "[core][dynamics]") {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        test::Random random(seed);
        CAPTURE(seed);
        // turns that lie 6 mm apart: for a point 4 mm away, the nearest turn is not the right one
        CurveFollowed c{};
        c.curve.linear = Vec3(0.0, 0.0, 1e-3);
        c.curve.harmonics = {{Vec3::UnitX(), Vec3::UnitY()}};
        const double theta = random.number(-60.0, 60.0);
        const double rate = random.number(10.0, 30.0);
        const double before = random.number(0.0, 1.0);
        const double now = before + random.number(1.0, 2.0);
        c.so_far = TurnsSoFar{before, theta - rate * (now - before) + random.number(-0.8, 0.8), rate};
        const Vec3 point = c.curve.at(theta).c + Vec3(0.0, 0.0, 4e-3);
        CHECK(std::abs(c.parameter(point, now) - theta) < 1e-4);
        // the nearest of all turns is the next one
        c.so_far.reset();
        CHECK(c.parameter(c.curve.at(theta).c, now) == Approx(theta).margin(1e-9));

        const Vec3 tangent = random.direction();
        CHECK(c.side_at(tangent) == perpendicular_to(tangent));
        c.side = perpendicular_to(tangent);
        const Vec3 bent = (tangent + 0.2 * random.vector()).normalized();
        const Vec3 side = c.side_at(bent);
        CHECK(std::abs(side.dot(bent)) < 1e-15);
        CHECK(std::abs(side.norm() - 1.0) < 1e-15);
        // the direction across the curve that is nearest to the previous one
        CHECK(std::abs(side.dot(bent.cross(c.side))) < 1e-15);
        CHECK(side.dot(c.side) > 0.9);
        // along an axis that is taken out, a point may be at any distance
        c.P_i_local = random.vector();
        c.P_j_local = random.vector();
        c.free_axis = Vec3::UnitY();
        const auto somewhere = [&] { return kinematics_at<OmegaLocal>(random.vector(), random.unit_p()); };
        CHECK(std::abs(d_local_of(c, somewhere(), somewhere()).y()) < 1e-15);
        CHECK(c.side_at(Vec3::UnitX()) == Vec3(0.0, 0.0, -1.0));
        c.free_axis.setZero();
        // along the side itself there is no nearest direction
        CHECK(c.side_at(c.side) == perpendicular_to(c.side));
    }
}

TEST_CASE("Without one of its equations with θ a joint keeps what does not need θ", "[core][dynamics]") {
    test::Random random(5);
    const auto links_without = [&](const JointType& type, std::vector<Role> roles) {
        Mechanism mechanism = test::random_joint(random, type, ParallelForm::rule, ScrewAngleForm::rotation);
        for (const Role role : roles) { mechanism.joints[0].without.push_back({role, 0}); }
        return std::pair{mechanism, links_of(mechanism)};
    };
    for (const JointType& type : kJointTypes) {
        for (const Role role : type.roles) {
            if (!has_theta(role)) { continue; }
            CAPTURE(type.name, static_cast<int>(role));
            const auto [mechanism, links] = links_without(type, {role});
            int rows = 0;
            for (const Link& link : links) { rows += link.rows; }
            // the other two equations of a curve determine θ and leave one row; p1 and p2 of a screw stay
            CHECK(rows == (type.has_curve() ? 1 : type.has_angle() ? 4 : 0));
            if (type.has_curve()) { check_against_differences(moving(random, mechanism)); }
        }
    }
    const JointType& curve = *find_joint_type("curve");
    CHECK(links_without(curve, {Role::curve_x, Role::curve_z}).second.empty());

    // a circle without the equation across its plane is a cylinder
    constexpr double R = 0.7;
    Joint joint;
    joint.type = &curve;
    joint.body_j = 1;
    joint.geometry.curve = {Vec3::Zero(), Vec3::Zero(), {{R * Vec3::UnitX(), R * Vec3::UnitY()}}};
    joint.without = {{Role::curve_z, 0}};
    Mechanism mechanism;
    mechanism.bodies.resize(2);
    mechanism.joints = {joint};
    const Scene scene = moving(random, mechanism);
    const Link link = links_of(mechanism).at(0);
    for (int k = 0; k < 20; ++k) {
        const double angle = random.number(-3.0, 3.0);
        const double off = random.number(-0.3, 0.3);
        State state = scene.state;
        state.r[1] = Vec3((R + off) * std::cos(angle), (R + off) * std::sin(angle), random.number());
        const double value = scene.by_jacobian(link, link.equations[0].primitive, state, 0.0).value(0);
        CHECK(std::abs(std::abs(value) - std::abs(off)) < 1e-12);
    }
}
