#include "core/jets/euler_parameters.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "core/elementary/elementary.hpp"

namespace jw {

namespace {

// below this angle sin(x)/x equals 1 - x²/6 to the last bit of a double: x⁴/120 < 1e-18
constexpr double kSmallTurn = 1e-4;

/// Unit p of a rotation vector [rad].
Vec4 exponential(const Vec3& turn) {
    const double half = 0.5 * turn.norm();
    const auto [sine, cosine] = elementary::sine_and_cosine(half);
    const double sinc = half < kSmallTurn ? 1.0 - half * half / 6.0 : sine / half;
    Vec4 p;
    p << cosine, 0.5 * sinc * turn;
    return p;
}

}  // namespace

Mat3 rotation_matrix(const Vec4& p) {
    const Vec3 e = p.tail<3>();
    Mat3 A = 2.0 * (e * e.transpose() + p(0) * tilde(e));
    A.diagonal().array() += 2.0 * p(0) * p(0) - 1.0;
    return A;
}

Vec4 euler_parameters_of(const Mat3& A) {
    // 4 e_k²; the largest is at least 1, so the division below never loses digits
    const double trace = A.trace();
    Vec4 squares;
    squares << 1.0 + trace, (1.0 - trace) + 2.0 * A.diagonal().array();
    Eigen::Index largest = 0;
    squares.maxCoeff(&largest);

    const Vec3 skew(A(2, 1) - A(1, 2), A(0, 2) - A(2, 0), A(1, 0) - A(0, 1));  // 4 e0 e
    Vec4 p;
    if (largest == 0) {
        p << squares(0), skew;
    } else {
        const Eigen::Index k = largest - 1;
        p(0) = skew(k);
        p.tail<3>() = A.col(k) + A.row(k).transpose();  // 4 e_k e, except for the diagonal
        p(largest) = squares(largest);
    }
    p.normalize();
    return p(0) < 0.0 ? Vec4(-p) : p;
}

Vec4 euler_parameters_of(const Vec3& axis, double angle) {
    Vec4 p;
    const auto [sine, cosine] = elementary::sine_and_cosine(0.5 * angle);
    p << cosine, sine * axis.stableNormalized();
    return p;
}

namespace {

/// Unit vector perpendicular to the unit vector `a`: the image of the z axis in the reflection that takes `a`
/// onto the x axis.
Vec3 across(const Vec3& a) {
    const double share = a.z() / (1.0 + std::abs(a.x()));
    return {a.x() < 0.0 ? a.z() : -a.z(), -share * a.y(), 1.0 - share * a.z()};
}

}  // namespace

// Written out: Eigen's FromTwoVectors takes the axis of a half turn from a singular value decomposition,
// which is most of the compile time of a source that calls it. The results are the same.
Vec4 euler_parameters_between(const Vec3& from, const Vec3& to) {
    // below this value of 1 + cosine, the axis that both define is lost in rounding
    constexpr double kOpposite = 1e-12;
    constexpr double kNearlyOpposite = -0.9;
    const Vec3 a = from.normalized();
    const Vec3 b = to.normalized();
    const double cosine = b.dot(a);
    Vec4 p;
    if (cosine < kOpposite - 1.0) {
        p << 0.0, across(a);
    } else {
        // for nearly opposite directions, 1 + cosine is mostly rounding, but their sum is not
        const double twice = cosine > kNearlyOpposite ? std::sqrt((1.0 + cosine) * 2.0) : (a + b).norm();
        p << twice * 0.5, a.cross(b) * (1.0 / twice);
    }
    return p;
}

Vec4 turned_local(const Vec4& p, const Vec3& turn_local) {
    return product(p, exponential(turn_local)).normalized();
}

Vec4 turned_global(const Vec4& p, const Vec3& turn) { return product(exponential(turn), p).normalized(); }

Vec3 turn_local_between(const Vec4& from, const Vec4& to) {
    Vec4 conjugate = -from;
    conjugate(0) = from(0);
    Vec4 difference = product(conjugate, to);
    if (difference(0) < 0.0) { difference = -difference; }
    const Vec3 e = difference.tail<3>();
    const double sine = e.norm();
    const double half = elementary::atan2(sine, difference(0));
    return sine > 0.0 ? Vec3(2.0 * half / sine * e) : Vec3::Zero();
}

Vec4 p_dot_of_omega_global(const Vec4& p, const Vec3& omega_global) {
    return 0.5 * G_of(p).transpose() * omega_global;
}

Vec3 omega_global_of(const Vec4& p, const Vec4& p_dot) { return 2.0 * G_of(p) * p_dot; }

Vec3 omega_local_of(const Vec4& p, const Vec4& p_dot) { return 2.0 * L_of(p) * p_dot; }

Vec4 p_ddot_of_omega_global(const Vec4& p, const Vec3& omega_global, const Vec3& omega_global_dot) {
    return 0.5 * G_of(p).transpose() * omega_global_dot - 0.25 * omega_global.squaredNorm() * p;
}

Vec4 p_ddot_of_omega_local(const Vec4& p, const Vec3& omega_local, const Vec3& omega_local_dot) {
    return 0.5 * L_of(p).transpose() * omega_local_dot - 0.25 * omega_local.squaredNorm() * p;
}

Vec3 omega_global_dot_of(const Vec4& p, const Vec4& p_ddot) { return 2.0 * G_of(p) * p_ddot; }

Vec3 omega_local_dot_of(const Vec4& p, const Vec4& p_ddot) { return 2.0 * L_of(p) * p_ddot; }

}  // namespace jw
