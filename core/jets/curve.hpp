#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/numerics/linear.hpp"

/// Curves that are fixed in a body, as functions of one parameter.
namespace jw {

/// c(u) = constant + linear u + Σ cos_k cos(k u) + sin_k sin(k u) [m], k = 1, 2, ...: lines, circles,
/// helices, and any closed curve. All its derivatives are continuous.
struct Curve {
    struct Harmonic {
        Vec3 cos = Vec3::Zero();
        Vec3 sin = Vec3::Zero();

        bool operator==(const Harmonic&) const = default;
    };
    struct Point {
        Vec3 c;     ///< [m]
        Vec3 c_u;   ///< its derivatives by u [m/rad]
        Vec3 c_uu;  ///< [m/rad²]
    };

    Vec3 constant = Vec3::Zero();
    Vec3 linear = Vec3::Zero();  ///< [m/rad]
    std::vector<Harmonic> harmonics;

    Point at(double u) const;
    /// True if a turn of u leads back to the same point.
    bool is_closed() const { return linear.isZero(0.0); }
    /// Parameter of the point of the curve that is nearest to `point`, by Newton's method from `guess` on.
    double nearest(const Vec3& point, double guess) const;
    /// Parameter of the nearest point of the whole curve: in (-π, π] if it is closed.
    double nearest(const Vec3& point) const;
    /// Parameter of the point nearest to one that is followed along the curve, by Newton's method from
    /// `expected` on. If their distance exceeds |c_u| times 0.01 rad, the point was not followed to here, and
    /// the whole curve is searched.
    double followed(const Vec3& point, double expected) const;

    /// Closed curve with the fewest harmonics through points that are evenly spaced in u, from u = 0 on.
    /// @throws std::invalid_argument for fewer than three points
    static Curve through(std::span<const Vec3> points);

    bool operator==(const Curve&) const = default;
};

/// One component of a curve: its constant, its factor of u, and (cos, sin) of each harmonic.
struct CurveComponent {
    double constant = 0.0;
    double linear = 0.0;
    std::vector<std::array<double, 2>> harmonics;
};
CurveComponent component_of(const Curve& curve, int component);

}  // namespace jw
