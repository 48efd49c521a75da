#include <catch2/catch.hpp>

#include <cmath>

#include "core/kinematics/motion_tracker.hpp"
#include "tests/support/scenes.hpp"

/// Points on curves, against closed forms.
using namespace jw;
using test::kPi;

TEST_CASE("A closed curve goes through its points, and its nearest points are found", "[core][curves]") {
    for (unsigned seed = 0; seed < 300; ++seed) {
        CAPTURE(seed);
        test::Random random(seed);
        const auto count = static_cast<std::size_t>(random.number(3.0, 30.0));
        std::vector<Vec3> points;
        for (std::size_t k = 0; k < count; ++k) { points.push_back(random.vector()); }
        const Curve curve = Curve::through(points);
        for (std::size_t k = 0; k < count; ++k) {
            const double u = 2.0 * kPi * static_cast<double>(k) / static_cast<double>(count);
            // some thirty terms of size 1
            CHECK((curve.at(u).c - points[k]).norm() < 1e-13);
        }
        // derivatives by differences, of waves up to 15
        const double u = random.number(-3.0, 3.0);
        constexpr double h = 1e-5;
        const Vec3 by_difference = (curve.at(u + h).c - curve.at(u - h).c) / (2.0 * h);
        CHECK((curve.at(u).c_u - by_difference).norm() < 1e-5 * (1.0 + by_difference.norm()));
        const Vec3 second = (curve.at(u + h).c_u - curve.at(u - h).c_u) / (2.0 * h);
        CHECK((curve.at(u).c_uu - second).norm() < 1e-5 * (1.0 + second.norm()));
        // a point on the curve is its own nearest one
        const double found = curve.nearest(curve.at(u).c);
        CHECK((curve.at(found).c - curve.at(u).c).norm() < 1e-12);
        // none of many other points is nearer to a point beside it
        const Vec3 beside = random.vector(1.5);
        const double nearest = (curve.at(curve.nearest(beside)).c - beside).norm();
        for (int k = 0; k < 1000; ++k) {
            CHECK_FALSE((curve.at(2.0 * kPi * k / 1000).c - beside).norm() < 0.98 * nearest - 1e-9);
        }
    }
}

TEST_CASE("A follower on a round cam moves as its triangle says, turn after turn", "[core][curves]") {
    for (unsigned seed = 0; seed < 20; ++seed) {
        CAPTURE(seed);
        test::Random random(seed);
        const double R = random.number(0.2, 0.5);
        const double e = R * random.number(0.05, 0.9);
        test::SceneBuilder scene;
        const Vec3 axis = random.direction();
        const Vec3 up = perpendicular_to(axis);
        const Vec3 across = up.cross(axis);
        const int cam = scene.add_body("cam", random.vector(0.1));
        const int follower = scene.add_body("follower", (e + R) * up);
        scene.add_joint("revolute", 0, cam, Vec3::Zero(), axis);
        scene.add_joint("prismatic", 0, follower, Vec3::Zero(), up);
        // the middle of the circle lies at e along `up`, and the follower on top of it
        const Vec3 x = scene.local(cam, across);
        const Vec3 y = scene.local(cam, up);
        Curve circle{e * y, Vec3::Zero(), {{R * y, R * x}}};
        Joint& joint = scene.add_joint("curve", cam, follower, Vec3::Zero(), axis);
        joint.geometry.P_j_local = scene.local_point(follower, (e + R) * up);
        joint.geometry.curve = circle;
        joint.geometry.theta_start = 0.0;
        Mechanism mechanism = scene.mechanism;
        const double rate = random.number(-6.0, 6.0);
        test::drive_angle(mechanism, 0, test::polynomial({0.0, rate}));
        System system(mechanism, everything(mechanism));
        MotionTracker tracker(system, start_state(mechanism), 0.0);
        const int samples = 2 + static_cast<int>(random.number(0.0, 100.0));
        for (int k = 1; k <= samples; ++k) {
            const double t = 6.0 * k / samples;
            REQUIRE(tracker.advance_to(t));
            // the cam has turned by φ: its middle stands at e (cos φ up - sin φ across')
            const double phi = rate * t;
            const double height =
                e * std::cos(phi) + std::sqrt(R * R - e * e * std::sin(phi) * std::sin(phi));
            const Vec3 found = tracker.frame().state.r[2] - mechanism.bodies[2].r;
            CAPTURE(t, phi);
            CHECK((found - (height - e - R) * up).norm() < 1e-11);
        }
    }
}

TEST_CASE("A point on a curve keeps three equations of rank three, with a column for θ", "[core][curves]") {
    for (unsigned seed = 0; seed < 50; ++seed) {
        CAPTURE(seed);
        test::Random random(seed);
        test::SceneBuilder scene;
        const int body = scene.add_body("bead", random.vector());
        Curve curve{Vec3::Zero(), random.vector(0.2), {{random.vector(), random.vector()}}};
        scene.add_curve(0, body, random.vector(), random.number(-3.0, 3.0), curve);
        const RankReport report = test::rank_of(scene.mechanism);
        CHECK(report.rows == 3);
        CHECK(report.columns == 7);
        CHECK(report.rank == 3);
        CHECK(report.residual < 1e-14);
    }
}
