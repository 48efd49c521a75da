#pragma once

#include "core/numerics/linear.hpp"

/// Euler parameters p = (e0, e1, e2, e3) = (cos φ/2, u sin φ/2) and every conversion of slide 13 in its
/// correct form (docs/notation.md lists those that are printed wrongly).
namespace jw {

/// G = [-e, ẽ + e0 I], 3x4; ω = 2 G ṗ.
inline Mat34 G_of(const Vec4& p) {
    Mat34 m;
    // clang-format off
    m << -p(1),  p(0), -p(3),  p(2),
         -p(2),  p(3),  p(0), -p(1),
         -p(3), -p(2),  p(1),  p(0);
    // clang-format on
    return m;
}

/// L = [-e, -ẽ + e0 I], 3x4; ω' = 2 L ṗ.
inline Mat34 L_of(const Vec4& p) {
    Mat34 m;
    // clang-format off
    m << -p(1),  p(0),  p(3), -p(2),
         -p(2), -p(3),  p(0),  p(1),
         -p(3),  p(2), -p(1),  p(0);
    // clang-format on
    return m;
}

/// A_N = (2 e0² - 1) I + 2 (e eᵀ + e0 ẽ): the matrix of slide 24. Orthogonal only for unit p;
/// p is used unchanged, never normalised here, so that derivatives with respect to p stay correct.
Mat3 rotation_matrix(const Vec4& p);

/// A_H = G Lᵀ = |p|² R: equal to A_N on the unit sphere, a scaled rotation everywhere.
inline Mat3 homogeneous_rotation_matrix(const Vec4& p) {
    const Vec3 e = p.tail<3>();
    const Vec3 twice = 2.0 * e;
    const double xy = twice.x() * e.y();
    const double xz = twice.x() * e.z();
    const double yz = twice.y() * e.z();
    const Vec3 turned = p(0) * twice;
    const Vec3 squares = e.cwiseProduct(e);
    const double e0_square = p(0) * p(0);
    Mat3 A;
    // clang-format off
    A << e0_square + squares.x() - squares.y() - squares.z(), xy - turned.z(), xz + turned.y(),
         xy + turned.z(), e0_square - squares.x() + squares.y() - squares.z(), yz - turned.x(),
         xz - turned.y(), yz + turned.x(), e0_square - squares.x() - squares.y() + squares.z();
    // clang-format on
    return A;
}

/// Unit p with e0 >= 0 of an orthonormal right-handed `A`; divides by the largest of the four
/// parameters, so half turns are as exact as small ones.
Vec4 euler_parameters_of(const Mat3& A);

/// Unit p of a turn by `angle` [rad] about `axis` (any length, not zero).
Vec4 euler_parameters_of(const Vec3& axis, double angle);

/// p of the shortest turn of the direction `from` onto that of `to` (any lengths, not zero); where they are
/// opposite, a half turn about some axis perpendicular to both.
Vec4 euler_parameters_between(const Vec3& from, const Vec3& to);

/// Quaternion product a b: first turn by b, then by a (both in the frame in which a is given).
inline Vec4 product(const Vec4& a, const Vec4& b) {
    const Vec3 a_e = a.tail<3>();
    const Vec3 b_e = b.tail<3>();
    Vec4 p;
    p << a(0) * b(0) - a_e.dot(b_e), a(0) * b_e + b(0) * a_e + a_e.cross(b_e);
    return p;
}

/// p of a body turned further by the rotation vector `turn_local` [rad, body frame].
Vec4 turned_local(const Vec4& p, const Vec3& turn_local);

/// p of a body turned further by the rotation vector `turn` [rad, global frame].
Vec4 turned_global(const Vec4& p, const Vec3& turn);

/// Shortest rotation vector v [rad, body frame of `from`] for which turned_local(from, v) is `to` or -`to`.
Vec3 turn_local_between(const Vec4& from, const Vec4& to);

Vec4 p_dot_of_omega_global(const Vec4& p, const Vec3& omega_global);  ///< ṗ = 1/2 Gᵀ ω
/// ṗ = 1/2 Lᵀ ω'
inline Vec4 p_dot_of_omega_local(const Vec4& p, const Vec3& omega_local) {
    return 0.5 * L_of(p).transpose() * omega_local;
}
Vec3 omega_global_of(const Vec4& p, const Vec4& p_dot);  ///< ω = 2 G ṗ
Vec3 omega_local_of(const Vec4& p, const Vec4& p_dot);   ///< ω' = 2 L ṗ

/// p̈ = 1/2 Gᵀ ω̇ - 1/4 (ω·ω) p
Vec4 p_ddot_of_omega_global(const Vec4& p, const Vec3& omega_global, const Vec3& omega_global_dot);
/// p̈ = 1/2 Lᵀ ω̇' - 1/4 (ω'·ω') p
Vec4 p_ddot_of_omega_local(const Vec4& p, const Vec3& omega_local, const Vec3& omega_local_dot);
Vec3 omega_global_dot_of(const Vec4& p, const Vec4& p_ddot);  ///< ω̇ = 2 G p̈
Vec3 omega_local_dot_of(const Vec4& p, const Vec4& p_ddot);   ///< ω̇' = 2 L p̈

}  // namespace jw
