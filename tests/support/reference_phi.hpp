#pragma once

#include <cmath>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/equations/system.hpp"
#include "tests/reference/natural_spline.hpp"
#include "tests/support/formula_value.hpp"

/// Φ of a system in long double, written from the definitions of the slides alone: no jets, no shared code.
/// Tests differentiate it.
namespace jw::reference {

using Real = long double;
using V3 = Eigen::Matrix<Real, 3, 1>;
using V4 = Eigen::Matrix<Real, 4, 1>;
using M3 = Eigen::Matrix<Real, 3, 3>;
using VX = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

/// Positions of all bodies and θ.
struct Positions {
    std::vector<V3> r;
    std::vector<V4> p;
    std::vector<Real> theta;
};

/// Rotation matrix entry by entry as printed on slide 24 (A_N); the homogeneous one replaces 2 e0² - 1 + 2
/// e_k² by e0² + e_k² - (the other two)².
inline M3 rotation(const V4& p, bool homogeneous) {
    const Real e0 = p(0), e1 = p(1), e2 = p(2), e3 = p(3);
    M3 A;
    A << 0, e1 * e2 - e0 * e3, e1 * e3 + e0 * e2, e1 * e2 + e0 * e3, 0, e2 * e3 - e0 * e1, e1 * e3 - e0 * e2,
        e2 * e3 + e0 * e1, 0;
    A *= 2;
    if (homogeneous) {
        A(0, 0) = e0 * e0 + e1 * e1 - e2 * e2 - e3 * e3;
        A(1, 1) = e0 * e0 - e1 * e1 + e2 * e2 - e3 * e3;
        A(2, 2) = e0 * e0 - e1 * e1 - e2 * e2 + e3 * e3;
    } else {
        A(0, 0) = 2 * (e0 * e0 + e1 * e1) - 1;
        A(1, 1) = 2 * (e0 * e0 + e2 * e2) - 1;
        A(2, 2) = 2 * (e0 * e0 + e3 * e3) - 1;
    }
    return A;
}

inline V3 to_real(const Vec3& v) { return v.cast<Real>(); }

/// Φ: rows of joints and drivers in the order of the system, then pᵀp - 1 if `normalised`.
inline VX phi(const System& system, const Positions& q, Real t, bool homogeneous, bool normalised) {
    const Mechanism& mechanism = system.mechanism();
    const std::vector<int> thetas = mechanism.theta_indices();
    std::vector<Real> rows;
    const auto body = [&](int b) { return static_cast<std::size_t>(b); };

    for (const Constraint& c : system.constraints()) {
        const Joint& joint = mechanism.joints[static_cast<std::size_t>(c.joint)];
        const JointGeometry& g = joint.geometry;
        const M3 A_i = rotation(q.p[body(c.body_i)], homogeneous);
        const M3 A_j = rotation(q.p[body(c.body_j)], homogeneous);
        const V3 P_i = q.r[body(c.body_i)] + A_i * to_real(g.P_i_local);
        const V3 P_j = q.r[body(c.body_j)] + A_j * to_real(g.P_j_local);
        const V3 s_i = A_i * to_real(g.s_i_local);
        const V3 s_j = A_j * to_real(g.s_j_local);
        const V3 d = P_j - P_i;
        std::vector<Real> all;
        const auto push = [&](const V3& v) { all = {v.x(), v.y(), v.z()}; };
        const V3 unit = s_i / to_real(g.s_i_local).norm();
        const Real theta = c.theta >= 0 ? q.theta[static_cast<std::size_t>(c.theta)] : 0;
        const bool pair = is_parallel(c.role) && joint.parallel_form == ParallelForm::pair;
        const V3 a = A_i * to_real(perpendicular_to(g.s_i_local));
        const V3 b = A_i * to_real(g.s_i_local.normalized().cross(perpendicular_to(g.s_i_local)));
        switch (c.role) {
            case Role::same_point: push(-d); break;
            case Role::axes_parallel:
                pair ? void(all = {a.dot(s_j), b.dot(s_j)}) : push(s_i.cross(s_j));
                break;
            case Role::distance_parallel: pair ? void(all = {a.dot(d), b.dot(d)}) : push(s_i.cross(d)); break;
            case Role::axes_perpendicular: all = {s_i.dot(s_j)}; break;
            case Role::distance_perpendicular: all = {s_i.dot(d)}; break;
            case Role::distance_perpendicular_j: all = {s_j.dot(d)}; break;
            case Role::sides_perpendicular:
                all = {(A_i * to_real(g.h_i_local)).dot(A_j * to_real(g.h_j_local))};
                break;
            case Role::length: all = {d.dot(d) - Real(g.length) * Real(g.length)}; break;
            case Role::formula:
                all = {test::formula_value(
                    g.formula.steps,
                    test::formula_variables(g, q.r[body(c.body_i)], A_i, q.r[body(c.body_j)], A_j))};
                break;
            case Role::screw_advance:
                all = {unit.dot(d) - Real(g.d_0) - Real(g.alpha) * (theta - Real(g.theta_0))};
                break;
            case Role::screw_angle: {
                const V3 u_i = A_i * to_real(g.u_i_local);
                const V3 u_j = A_j * to_real(g.u_j_local);
                const Real sine = u_i.cross(u_j).dot(unit);
                const Real cosine = u_i.dot(u_j);
                switch (g.screw_angle_form) {
                    case ScrewAngleForm::rotation:
                        all = {sine * std::cos(theta) - cosine * std::sin(theta)};
                        break;
                    case ScrewAngleForm::cosine: all = {cosine - std::cos(theta)}; break;
                    case ScrewAngleForm::sine: all = {sine - std::sin(theta)}; break;
                }
                break;
            }
            case Role::wheel_i:
            case Role::wheel_j:
            case Role::bevel_i:
            case Role::bevel_j:
            case Role::rack_angle: {
                const bool of_j = c.role != Role::wheel_i && c.role != Role::bevel_i;
                const bool follows = c.role == Role::wheel_j || c.role == Role::bevel_j;
                const V3 s_j_unit = s_j / to_real(g.s_j_local).norm();
                const V3 u = of_j ? V3(A_j * to_real(g.u_j_local)) : V3(A_i * to_real(g.u_i_local));
                const V3 s = of_j ? s_j_unit : unit;
                V3 e = d;
                if (c.role == Role::rack_angle) { e = unit; }
                if (c.role == Role::bevel_i || c.role == Role::bevel_j) { e = unit.cross(s_j_unit); }
                const Real angle = follows ? Real(g.ratio) * theta : theta;
                all = {e.cross(u).dot(s) * std::cos(angle) - e.dot(u) * std::sin(angle)};
                break;
            }
            case Role::curve_x:
            case Role::curve_y:
            case Role::curve_z: {
                const int k = static_cast<int>(c.role) - static_cast<int>(Role::curve_x);
                Real of_curve = Real(g.curve.constant(k)) + Real(g.curve.linear(k)) * theta;
                for (std::size_t n = 0; n < g.curve.harmonics.size(); ++n) {
                    const Real angle = Real(n + 1) * theta;
                    of_curve += Real(g.curve.harmonics[n].cos(k)) * std::cos(angle) +
                                Real(g.curve.harmonics[n].sin(k)) * std::sin(angle);
                }
                all = {A_i.col(k).dot(d) - of_curve};
                break;
            }
            case Role::rack_advance:
                all = {unit.dot(d) - Real(g.d_0) - Real(g.alpha) * (theta - Real(g.theta_0))};
                break;
        }
        for (std::size_t k = 0; k < all.size(); ++k) {
            if (c.has_row(static_cast<int>(k))) { rows.push_back(all[k]); }
        }
    }

    for (const DriverConstraint& c : system.drivers()) {
        const Driver& driver = mechanism.drivers[static_cast<std::size_t>(c.driver)];
        const M3 A_i = rotation(q.p[body(driver.body_i)], homogeneous);
        const M3 A_j = rotation(q.p[body(driver.body_j)], homogeneous);
        // the time function again, from its parts
        Real f = 0;
        Real power = 1;
        for (const double coefficient : driver.function.polynomial) {
            f += Real(coefficient) * power;
            power *= t;
        }
        for (const auto& h : driver.function.harmonics) {
            f += Real(h.amplitude) * std::sin(Real(h.omega) * t + Real(h.phase));
        }
        for (const auto& s : driver.function.steps) {
            const Real u =
                std::min(Real(1), std::max(Real(0), (t - Real(s.start)) / (Real(s.end) - Real(s.start))));
            f += Real(s.from) +
                 (Real(s.to) - Real(s.from)) * (6 * u * u * u * u * u - 15 * u * u * u * u + 10 * u * u * u);
        }
        if (driver.function.table) {
            const TimeTable& table = *driver.function.table;
            f += reference::natural_spline(table.times, table.values, Real(t));
        }
        if (driver.function.formula) {
            const TimeFormula& formula = *driver.function.formula;
            f += Real(formula.unit) * static_cast<Real>(test::formula_value(formula.formula.steps, t));
        }
        if (const auto* m = std::get_if<AngleMeasure>(&driver.measure)) {
            const V3 u_i = A_i * to_real(m->u_i_local);
            const V3 u_j = A_j * to_real(m->u_j_local);
            const Real angle = std::atan2(u_i.cross(u_j).dot(A_i * to_real(m->s_i_local)), u_i.dot(u_j));
            rows.push_back(std::remainder(angle - f, 2 * std::numbers::pi_v<Real>));
        } else if (const auto* m2 = std::get_if<DisplacementMeasure>(&driver.measure)) {
            const V3 d = q.r[body(driver.body_j)] + A_j * to_real(m2->B_j_local) - q.r[body(driver.body_i)] -
                         A_i * to_real(m2->B_i_local);
            rows.push_back((A_i * to_real(m2->s_i_local)).dot(d) - f);
        } else if (const auto* m3 = std::get_if<SquaredDistanceMeasure>(&driver.measure)) {
            const V3 d = q.r[body(driver.body_j)] + A_j * to_real(m3->P_j_local) - q.r[body(driver.body_i)] -
                         A_i * to_real(m3->P_i_local);
            rows.push_back(d.dot(d) - f * f);
        } else if (const auto* m4 = std::get_if<CoordinateMeasure>(&driver.measure)) {
            const std::size_t j = body(driver.body_j);
            rows.push_back((m4->coordinate < 3 ? q.r[j](m4->coordinate) : q.p[j](m4->coordinate - 3)) - f);
        } else {
            rows.push_back(
                q.theta[static_cast<std::size_t>(thetas[static_cast<std::size_t>(driver.joint)])] - f);
        }
    }
    if (normalised) {
        for (const int b : system.moving_bodies()) { rows.push_back(q.p[body(b)].squaredNorm() - 1); }
    }
    VX out(static_cast<Eigen::Index>(rows.size()));
    for (std::size_t k = 0; k < rows.size(); ++k) { out(static_cast<Eigen::Index>(k)) = rows[k]; }
    return out;
}

}  // namespace jw::reference
