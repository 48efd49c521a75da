#pragma once

#include "core/jets/curve.hpp"

namespace jw {

/// Parameter of a point that is followed along a curve: the nearest one from `expected` on. A point that is
/// farther away from there than a hundredth of a radian was not followed to here, and has that of the whole
/// curve.
inline double followed(const Curve& curve, const Vec3& point, double expected) {
    constexpr double beside = 0.01;
    const double u = curve.nearest(point, expected);
    const Curve::Point found = curve.at(u);
    return (found.c - point).norm() < beside * found.c_u.norm() ? u : curve.nearest(point);
}

}  // namespace jw
