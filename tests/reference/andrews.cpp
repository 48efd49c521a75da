#include "tests/reference/scene_parts.hpp"
#include "tests/reference/scenes.hpp"

namespace jw::reference {

namespace {

// constants of the IVP test set [m], [rad]
constexpr Real d = 0.028L, da = 0.0115L, e = 0.02L, ea = 0.01421L, rr = 0.007L, ra = 0.00092L, ss = 0.035L,
               sa = 0.01874L, sb = 0.01043L, sc = 0.018L, sd = 0.02L, ta = 0.02308L, tb = 0.00916L, u = 0.04L,
               ua = 0.01228L, ub = 0.00449L, zf = 0.02L, zt = 0.04L, fa = 0.01421L;
constexpr Real beta = -0.0617138900142764496L, theta = 0.0L, gamma = 0.455279819163070380L,
               phi = 0.222668390165885885L, delta = 0.487364979543842550L, omega = -0.222668390165885885L,
               epsilon = 1.23054744454982119L;

Vec3 planar(Real x, Real y) { return {x, y, 0.0L}; }
/// (cos, sin) of an angle, and the direction a quarter turn behind it.
Vec3 along(Real angle) { return planar(std::cos(angle), std::sin(angle)); }
Vec3 behind(Real angle) { return planar(std::sin(angle), -std::cos(angle)); }

/// Adds a planar body. Its moments of inertia about x and y have no effect; that about z is used for all.
int add_link(Scene& scene, const Vec3& centre, Real angle, Real mass, Real J) {
    Body body;
    body.mass = mass;
    body.J = Vec3::Constant(J);
    body.r = centre;
    body.p = turn(Vec3::UnitZ(), angle);
    return add(scene, body);
}

}  // namespace

Scene andrews() {
    Scene s = scene_named("andrews", "A03, point F", Vec3::Zero(), 0.05L);
    const Vec3 O = Vec3::Zero();
    const Vec3 A = planar(-0.06934L, -0.00227L);
    const Vec3 B = planar(-0.03635L, 0.03273L);
    const Vec3 C = planar(0.014L, 0.072L);
    const Vec3 F = rr * along(beta);
    const Vec3 E = F - d * along(beta + theta);
    const Vec3 G = A + zt * along(delta);
    const Vec3 H = A + u * behind(epsilon);
    const Vec3 D = B + sd * along(gamma) + sc * behind(gamma);

    const int K1 = add_link(s, ra * along(beta), beta, 0.04325L, 2.194e-6L);
    const int K2 = add_link(s, F - da * along(beta + theta), beta + theta, 0.00365L, 4.410e-7L);
    const int K3 = add_link(s, B + sa * behind(gamma) + sb * along(gamma), gamma, 0.02373L, 5.255e-6L);
    const int K4 = add_link(s, G + (e - ea) * behind(phi + delta), phi + delta, 0.00706L, 5.667e-7L);
    const int K5 = add_link(s, A + ta * along(delta) - tb * behind(delta), delta, 0.07050L, 1.169e-5L);
    const int K6 = add_link(s, H + (zf - fa) * along(epsilon + omega), omega + epsilon, 0.00706L, 5.667e-7L);
    const int K7 = add_link(s, A + ua * behind(epsilon) + ub * along(epsilon), epsilon, 0.05498L, 1.912e-5L);

    hinge(s, JointKind::revolute, 0, K1, O);
    hinge(s, JointKind::revolute, K1, K2, F);
    hinge(s, JointKind::revolute, 0, K3, B);
    hinge(s, JointKind::revolute, 0, K5, A);
    hinge(s, JointKind::revolute, K5, K4, G);
    hinge(s, JointKind::revolute, 0, K7, A);
    hinge(s, JointKind::revolute, K7, K6, H);
    close(s, K2, K3, E);
    close(s, K2, K4, E);
    close(s, K2, K6, E);
    s.springs.push_back({0, K3, C, D, 4530.0L, 0.0L, 0.07785L});
    s.driven = K1;
    s.torque = Vec3(0.0L, 0.0L, 0.033L);
    s.body = K1;
    s.point = F;
    return s;
}

}  // namespace jw::reference
