#include "tests/reference/closed_forms.hpp"

#include <functional>

namespace jw::reference {

namespace {

/// Integral of f over [a, b] by Gauss-Legendre with 12 points on each of `panels`.
Real integral(const std::function<Real(Real)>& f, Real a, Real b, int panels) {
    constexpr int n = 12;
    Real sum = 0.0L;
    for (int k = 0; k < n; ++k) {
        // node and weight by Newton on Legendre's polynomial
        Real x = std::cos(kPi * (static_cast<Real>(k) + 0.75L) / (n + 0.5L));
        Real slope = 1.0L;
        for (int iteration = 0; iteration < 8; ++iteration) {
            Real p = x;
            Real before = 1.0L;
            for (int m = 2; m <= n; ++m) {
                const Real next = ((2 * m - 1) * x * p - (m - 1) * before) / m;
                before = p;
                p = next;
            }
            slope = n * (x * p - before) / (x * x - 1.0L);
            x -= p / slope;
        }
        const Real weight = 2.0L / ((1.0L - x * x) * slope * slope);
        const Real width = (b - a) / static_cast<Real>(panels);
        for (int panel = 0; panel < panels; ++panel) {
            sum += weight * width / 2.0L * f(a + width * (static_cast<Real>(panel) + (1.0L + x) / 2.0L));
        }
    }
    return sum;
}

/// Angle from the hanging position and its rate, as sine and cosine.
struct Swing {
    Real sine, cosine, rate;
};

/// A01: released level. sin(θ/2) = k sn(w t + K), k = sin 45°.
Trajectory pendulum(const Scene& scene) {
    const Body& body = scene.bodies[1];
    const Real length = -body.r.x();
    const Real w =
        std::sqrt(-scene.gravity.y() * body.mass * length / (body.mass * length * length + body.J.z()));
    const Real k = std::sqrt(0.5L);
    const Modulus modulus{k, k};
    Trajectory out;
    for (int n = 0; n <= kIntervals; ++n) {
        const Jacobi e = jacobi(w * scene.duration * n / kIntervals + quarter_period(modulus), modulus);
        const Swing s{2.0L * k * e.sn * e.dn, e.dn * e.dn - k * k * e.sn * e.sn, 2.0L * k * w * e.cn};
        out.push_back(
            {length * Vec3(-s.sine, -s.cosine, 0.0L), s.rate * length * Vec3(-s.cosine, s.sine, 0.0L)});
    }
    return out;
}

/// A02: N + 1 upright rods turn as one; N couplers move with their tips. From the top with 1 rad/s they turn
/// all the way round: sin(θ/2) = sn(W t / 2 + K), W the rate at the bottom.
Trajectory four_bars(const Scene& scene) {
    const Real N = (static_cast<Real>(scene.bodies.size()) - 2.0L) / 2.0L;
    const Real w_squared = -scene.gravity.y() * ((N + 1.0L) / 2.0L + N) / ((N + 1.0L) / 3.0L + N);
    const Real start = 1.0L;
    const Real fastest = std::sqrt(start * start + 4.0L * w_squared);
    const Modulus modulus{2.0L * std::sqrt(w_squared) / fastest, start / fastest};
    Trajectory out;
    for (int n = 0; n <= kIntervals; ++n) {
        const Jacobi e =
            jacobi(fastest / 2.0L * scene.duration * n / kIntervals + quarter_period(modulus), modulus);
        const Swing s{2.0L * e.sn * e.cn, e.cn * e.cn - e.sn * e.sn, fastest * e.dn};
        // clockwise: from the top towards +x
        out.push_back({Vec3(-s.sine, -s.cosine, 0.0L), s.rate * Vec3(-s.cosine, s.sine, 0.0L)});
    }
    return out;
}

/// Released with spin only: u = cos θ falls from u0 to u1 and comes back.
Trajectory spinning_top(const Scene& scene) {
    const Body& top = scene.bodies[1];
    const Real l = top.r.norm();
    const Real A = top.J.x() + top.mass * l * l;
    const Vec3 axis_0 = top.r / l;
    const Real spin = top.omega.dot(axis_0);
    const Real u0 = axis_0.z();
    const Real beta = -2.0L * top.mass * scene.gravity.z() * l / A;
    const Real b = top.J.z() * spin / A;
    // u'² = beta (u0 - u)(u - u1)(u2 - u)
    const Real root = std::sqrt(b * b * b * b - 4.0L * beta * (b * b * u0 - beta));
    const Real u2 = (b * b + root) / (2.0L * beta);
    const Real u1 = (b * b * u0 - beta) / (beta * u2);
    const Real rate = std::sqrt(beta * (u2 - u1)) / 2.0L;
    const Modulus modulus{std::sqrt((u0 - u1) / (u2 - u1)), std::sqrt((u2 - u0) / (u2 - u1))};
    const auto at = [&](Real t) { return jacobi(rate * t + quarter_period(modulus), modulus); };
    const auto u_of = [&](const Jacobi& e) { return u1 + (u0 - u1) * e.sn * e.sn; };
    const auto precession = [&](Real t) {
        const Jacobi e = at(t);
        const Real u = u_of(e);
        return b * (u0 - u1) * e.cn * e.cn / (1.0L - u * u);
    };
    const Vec3 rim = rotation(top.p).transpose() * (scene.point - top.r);

    Trajectory out;
    Real phi = 0.0L;
    Real psi = 0.0L;
    for (int n = 0; n <= kIntervals; ++n) {
        const Real t = scene.duration * n / kIntervals;
        if (n > 0) {
            const Real before = scene.duration * (n - 1) / kIntervals;
            phi += integral(precession, before, t, 4);
            psi += integral([&](Real s) { return spin - precession(s) * u_of(at(s)); }, before, t, 4);
        }
        const Jacobi e = at(t);
        const Real u = u_of(e);
        const Real sine = std::sqrt(1.0L - u * u);
        const Real theta_dot = -2.0L * rate * (u0 - u1) * e.sn * e.cn * e.dn / sine;
        const Vec3 axis(sine * std::cos(phi), sine * std::sin(phi), u);
        const Vec3 side(u * std::cos(phi), u * std::sin(phi), -sine);
        const Vec3 across = axis.cross(side);
        const Vec3 x = std::cos(psi) * side + std::sin(psi) * across;
        const Vec3 r = l * axis + rim.x() * x + rim.y() * axis.cross(x) + rim.z() * axis;
        const Vec3 omega =
            precession(t) * Vec3::UnitZ() + theta_dot * across + (spin - precession(t) * u) * axis;
        out.push_back({r, omega.cross(r)});
    }
    return out;
}

/// Euler's free body with L² > 2 T J2: ω' = (a1 cn, a2 sn, a3 dn), all positive at the start. Seen along the
/// angular momentum, the node line of the third axis turns at a rate that ω3 gives.
Trajectory free_body(const Scene& scene) {
    const Body& body = scene.bodies[1];
    const Vec3& J = body.J;
    const Vec3 w0 = body.omega;  // axes of body and world agree at t = 0
    const Real L2 = J.cwiseProduct(w0).squaredNorm();
    const Real T2 = w0.dot(J.cwiseProduct(w0));
    // |2 T J_n - L²| as sums of terms of one sign, or nearly so: near the separatrix the small rest matters
    const Vec3 L2_each = J.cwiseProduct(J).cwiseProduct(w0).cwiseProduct(w0);
    const auto from = [&](int n) -> Real { return L2_each.dot((J - Vec3::Constant(J[n])).cwiseQuotient(J)); };
    const Real above_1 = from(0);
    const Real above_2 = from(1);
    const Real below_3 = -from(2);
    const Real d21 = J[1] - J[0], d31 = J[2] - J[0], d32 = J[2] - J[1];
    const Real a1 = std::sqrt(below_3 / (J[0] * d31));
    const Real a2 = std::sqrt(below_3 / (J[1] * d32));
    const Real a3 = std::sqrt(above_1 / (J[2] * d31));
    const Real rate = std::sqrt(d32 * above_1 / (J[0] * J[1] * J[2]));
    const Modulus k{std::sqrt(d21 * below_3 / (d32 * above_1)), std::sqrt(d31 * above_2 / (d32 * above_1))};
    const Real x0 = inverse_sn(w0[1] / a2, w0[0] / a1, k);
    const auto omega_local = [&](Real t) {
        const Jacobi e = jacobi(x0 + rate * t, k);
        return Vec3(a1 * e.cn, a2 * e.sn, a3 * e.dn);
    };
    const auto precession = [&](Real t) {
        const Real along = J[2] * omega_local(t)[2];
        return std::sqrt(L2) * (T2 - along * along / J[2]) / (L2 - along * along);
    };
    // columns: node line, the direction across it, angular momentum; in the body
    const auto frame = [&](const Vec3& w) {
        Mat3 F;
        F.col(2) = J.cwiseProduct(w).normalized();
        F.col(0) = F.col(2).cross(Vec3::UnitZ()).normalized();
        F.col(1) = F.col(2).cross(F.col(0));
        return F;
    };
    const Mat3 start = frame(w0);

    Trajectory out;
    Real psi = 0.0L;
    for (int n = 0; n <= kIntervals; ++n) {
        const Real t = scene.duration * n / kIntervals;
        if (n > 0) { psi += integral(precession, scene.duration * (n - 1) / kIntervals, t, 8); }
        const Vec3 w = omega_local(t);
        const Mat3 A = start * rotation(turn(Vec3::UnitZ(), psi)) * frame(w).transpose();
        out.push_back({A * scene.point, A * w.cross(scene.point)});
    }
    return out;
}

}  // namespace

std::optional<Trajectory> closed_form(const Scene& scene) {
    if (scene.name == "simple-pendulum") { return pendulum(scene); }
    if (scene.name.starts_with("four-bar")) { return four_bars(scene); }
    if (scene.name == "spinning-top") { return spinning_top(scene); }
    if (scene.name == "free-asymmetric-body") { return free_body(scene); }
    return std::nullopt;
}

}  // namespace jw::reference
