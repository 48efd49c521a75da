#pragma once

#include <cmath>
#include <vector>

#include <Eigen/Dense>

/// Numbers of the reference solver: long double, 19 digits. It shares no code and no formula with core.
namespace jw::reference {

using Real = long double;
using Vec3 = Eigen::Matrix<Real, 3, 1>;
using Vec4 = Eigen::Matrix<Real, 4, 1>;
using Mat3 = Eigen::Matrix<Real, 3, 3>;
using VecX = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using MatX = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

inline const Real kPi = std::acos(-1.0L);

/// Product of two quaternions (scalar first).
inline Vec4 product(const Vec4& p, const Vec4& q) {
    Vec4 out;
    out[0] = p[0] * q[0] - p.tail<3>().dot(q.tail<3>());
    out.tail<3>() = p[0] * q.tail<3>() + q[0] * p.tail<3>() + p.tail<3>().cross(q.tail<3>());
    return out;
}

/// Rotation of a quaternion of any length.
inline Mat3 rotation(const Vec4& p) {
    const Vec3 e = p.tail<3>();
    Mat3 cross;
    cross << 0.0L, -e.z(), e.y(), e.z(), 0.0L, -e.x(), -e.y(), e.x(), 0.0L;
    return Mat3::Identity() + 2.0L / p.squaredNorm() * (p[0] * cross + cross * cross);
}

/// Turn about a unit axis by an angle [rad].
inline Vec4 turn(const Vec3& axis, Real angle) {
    const Vec3 e = std::sin(angle / 2.0L) * axis;
    return Vec4(std::cos(angle / 2.0L), e.x(), e.y(), e.z());
}

/// Shortest turn that takes the x axis to `direction`.
inline Vec4 x_axis_to(const Vec3& direction) {
    const Vec3 d = direction.normalized();
    const Vec3 middle = Vec3::UnitX() + d;
    if (middle.norm() < 1e-9L) { return Vec4(0.0L, 0.0L, 0.0L, 1.0L); }
    const Vec3 m = middle.normalized();
    const Vec3 e = Vec3::UnitX().cross(m);
    return Vec4(m.x(), e.x(), e.y(), e.z());
}

}  // namespace jw::reference
