#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "core/motion/loads.hpp"
#include "tests/support/random_dynamics.hpp"

/// Equal cranks on one bar: parallelograms side by side, whose branches cross twice a turn, and whose motion
/// is that of a pendulum.
namespace jw::test {

/// Cranks on bearings in a row and the bar that joins their ends; anywhere in space, with random masses. Two
/// cranks are a parallelogram; with three or more, several loops pass their singular position at once.
struct ParallelCranks {
    Mechanism mechanism;
    Loads loads;
    Vec3 axis;  ///< unit, about which all cranks turn by θ
    std::vector<Vec3>
        bearings;            ///< of the cranks; of the bar: where its point on the first crank turns about
    std::vector<Vec3> arms;  ///< from there to the centre of mass at θ = 0; one per moving body
    double inertia = 0.0;    ///< of all that turns with θ [kg m²]
    double cosine = 0.0;     ///< torque of gravity: cosine cos θ + sine sin θ [N m]
    double sine = 0.0;
    double omega = 0.0;  ///< at the start [rad/s]

    /// θ and its rate at the times, which ascend: Runge-Kutta of fourth order in steps of 1e-4 s, long
    /// double.
    std::vector<std::array<double, 2>> angles(const std::vector<double>& times) const {
        using Real = long double;
        const auto rate = [&](Real a) { return (cosine * std::cos(a) + sine * std::sin(a)) / inertia; };
        std::vector<std::array<double, 2>> out;
        Real t = 0.0L;
        Real a = 0.0L;
        Real w = omega;
        for (const double time : times) {
            const int steps = static_cast<int>(std::ceil((static_cast<Real>(time) - t) * 1e4L));
            const Real h = steps > 0 ? (time - t) / steps : 0.0L;
            for (int k = 0; k < steps; ++k) {
                const Real w1 = w, b1 = rate(a);
                const Real w2 = w + h / 2 * b1, b2 = rate(a + h / 2 * w1);
                const Real w3 = w + h / 2 * b2, b3 = rate(a + h / 2 * w2);
                const Real w4 = w + h * b3, b4 = rate(a + h * w3);
                a += h / 6 * (w1 + 2 * w2 + 2 * w3 + w4);
                w += h / 6 * (b1 + 2 * b2 + 2 * b3 + b4);
            }
            t = time;
            out.push_back({static_cast<double>(a), static_cast<double>(w)});
        }
        return out;
    }

    /// Centre of mass of a moving body.
    Vec3 centre(std::size_t body, double angle) const {
        return bearings[body] + Eigen::AngleAxisd(angle, axis) * arms[body];
    }
};

inline ParallelCranks parallel_cranks(Random& random, int cranks) {
    SceneBuilder scene;
    ParallelCranks out;
    out.axis = random.direction();
    const Vec3 along =
        Eigen::AngleAxisd(random.number(0.0, 6.0), out.axis) * perpendicular_to(out.axis).normalized();
    const Vec3 arm = random.number(0.3, 1.2) * (Eigen::AngleAxisd(random.number(0.2, 6.0), out.axis) * along);
    out.omega = random.number(2.0, 20.0) * (random.number() < 0.0 ? -1.0 : 1.0);
    const Vec3 turning = out.omega * out.axis;
    Vec3 bearing = random.vector(2.0);
    const Vec3 first = bearing;
    std::vector<Vec3> ends;
    for (int k = 0; k < cranks; ++k) {
        const int body = scene.add_body("crank", bearing + 0.5 * arm);
        scene.add_joint("revolute", 0, body, bearing, out.axis);
        out.bearings.push_back(bearing);
        ends.push_back(bearing + arm);
        bearing += random.number(0.4, 1.5) * along;
    }
    const int bar = scene.add_body("bar", ends.front() + random.vector(0.5));
    for (int k = 0; k < cranks; ++k) { scene.add_joint("revolute", k + 1, bar, ends[at(k)], out.axis); }
    out.bearings.push_back(first);
    out.loads.masses = random_masses(random, scene.mechanism);
    out.loads.gravity = random.vector(9.81);
    Vec3 moment = Vec3::Zero();
    for (int b = 1; b <= bar; ++b) {
        Body& body = scene.mechanism.bodies[at(b)];
        const MassProperties& own = *out.loads.masses[at(b)];
        const Mat3 A = rotation_matrix(body.p);
        const Vec3 centre = body.r + A * own.centre_local;
        // the bar only moves along: all of it as its point on the first crank
        const Vec3 turned = b == bar ? arm : centre - out.bearings[at(b - 1)];
        if (b == bar) { out.bearings.back() += centre - ends.front(); }
        out.arms.push_back(turned);
        const Vec3 across = turned - out.axis.dot(turned) * out.axis;
        const Vec3 axis_local = A.transpose() * out.axis;
        out.inertia += own.mass * across.squaredNorm();
        if (b != bar) {
            out.inertia += axis_local.dot(own.J_local * axis_local);
            body.omega_local = A.transpose() * turning;
        }
        body.r_dot = turning.cross(b == bar ? arm : (body.r - out.bearings[at(b - 1)]).eval());
        moment += own.mass * across;
    }
    out.cosine = out.axis.dot(moment.cross(out.loads.gravity));
    out.sine = out.axis.dot(out.axis.cross(moment).cross(out.loads.gravity));
    out.mechanism = scene.mechanism;
    return out;
}

}  // namespace jw::test
