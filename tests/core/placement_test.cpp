#include <catch2/catch.hpp>

#include <cmath>

#include "core/model/placement.hpp"
#include "tests/support/random_mechanisms.hpp"

using namespace jw;

namespace {

/// `v` turned by the Euler parameters p = (e0, e): v + 2 e0 e × v + 2 e × (e × v).
Vec3 turned(const Vec4& p, const Vec3& v) {
    const Vec3 e = p.tail<3>();
    return v + 2.0 * p(0) * e.cross(v) + 2.0 * e.cross(e.cross(v));
}

/// `v` turned about the unit vector `n` by an angle, by Rodrigues' formula.
Vec3 turned_about(const Vec3& n, double angle, const Vec3& v) {
    return std::cos(angle) * v + std::sin(angle) * n.cross(v) + (1.0 - std::cos(angle)) * n.dot(v) * n;
}

/// A unit vector perpendicular to another one.
Vec3 across(test::Random& random, const Vec3& axis) { return axis.cross(random.vector()).normalized(); }

}  // namespace

TEST_CASE("Joints placed by global vectors have them in the global frame, in any poses", "[placement]") {
    for (unsigned seed = 0; seed < 2000; ++seed) {
        CAPTURE(seed);
        test::Random random(seed);
        const Body i = test::random_body(random, "i");
        const Body j = test::random_body(random, "j");
        const BodyPair pair{&i, &j};
        const JointType& type = kJointTypes[seed % kJointTypes.size()];
        const Vec3 at = random.vector();
        const Vec3 to = random.vector();
        const Vec3 axis = random.direction();
        const Vec3 normal = across(random, axis);
        // every third start is assembled; the others are up to 1 rad away from it
        const double tilt = seed % 3 == 0 ? 0.0 : random.number(0.0, 1.0);
        const Vec3 axis_j = turned_about(normal, tilt, axis);
        const Vec3 side = across(random, axis);

        JointGeometry g;
        g.P_i_local = pair.point_i(at);
        g.P_j_local = pair.point_j(to);
        g.s_i_local = pair.vector_i(axis);
        g.s_j_local = pair.vector_j(axis_j);
        set_sides(pair, type, side, g);

        constexpr double rounding = 1e-14;
        const auto is_near = [](const Vec3& a, const Vec3& b) { return (a - b).norm() < rounding; };
        CHECK(is_near(i.r + turned(i.p, g.P_i_local), at));
        CHECK(is_near(j.r + turned(j.p, g.P_j_local), to));
        CHECK(is_near(turned(i.p, g.s_i_local), axis));
        CHECK(is_near(turned(j.p, g.s_j_local), axis_j));
        CHECK(is_near(turned(i.p, g.u_i_local), side));
        const Vec3 other = type.has_angle() || type.has_formula() ? side : axis.cross(side);
        CHECK(is_near(turned(j.p, g.u_j_local), turned_about(normal, tilt, other)));
        CHECK(g.h_i_local == g.u_i_local);
        CHECK(g.h_j_local == g.u_j_local);
        CHECK(std::abs(start_displacement(pair, g) - (to - at).dot(axis)) < rounding);
        if (type.has_angle() && tilt == 0.0) { CHECK(std::abs(start_angle(pair, g)) < rounding); }
    }
}
