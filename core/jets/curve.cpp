#include "core/jets/curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "core/elementary/elementary.hpp"

namespace jw {

namespace {

constexpr double kWholeTurn = 2.0 * std::numbers::pi;
// sample points per period of the highest harmonic
constexpr int kPointsPerWave = 32;
// longest step of Newton's method, in periods of the highest harmonic
constexpr double kLongestStep = 0.1;
constexpr int kMostSteps = 60;

}  // namespace

Curve::Point Curve::at(double u) const {
    Point p{constant + u * linear, linear, Vec3::Zero()};
    double k = 0.0;
    for (const Harmonic& h : harmonics) {
        k += 1.0;
        const auto [sine, cosine] = elementary::sine_and_cosine(k * u);
        p.c += cosine * h.cos + sine * h.sin;
        p.c_u += k * (cosine * h.sin - sine * h.cos);
        p.c_uu -= k * k * (cosine * h.cos + sine * h.sin);
    }
    return p;
}

double Curve::nearest(const Vec3& point, double guess) const {
    const double longest =
        kLongestStep * kWholeTurn / std::max<double>(1.0, static_cast<double>(harmonics.size()));
    double u = guess;
    double last = std::numeric_limits<double>::infinity();
    for (int n = 0; n < kMostSteps; ++n) {
        const Point p = at(u);
        const Vec3 off = p.c - point;
        const double slope = p.c_u.dot(off);
        const double full = p.c_u.squaredNorm();
        // beyond the centre of curvature the distance has no minimum here: the step only follows its slope
        const double curvature = std::max(full + p.c_uu.dot(off), 0.1 * full);
        if (!(curvature > 0.0)) { return u; }
        const double step = std::clamp(-slope / curvature, -longest, longest);
        u += step;
        // steps of Newton's method shrink until they consist only of rounding
        if (step == 0.0 || (std::abs(step) < 1e-9 && std::abs(step) >= 0.5 * last)) { break; }
        last = std::abs(step);
    }
    return u;
}

double Curve::nearest(const Vec3& point) const {
    const int waves = std::max(1, static_cast<int>(harmonics.size()));
    const int points = kPointsPerWave * waves;
    // an open curve is searched one turn to either side of the point of its line that is nearest
    const double middle = is_closed() ? 0.0 : linear.dot(point - constant) / linear.squaredNorm();
    const double half = is_closed() ? 0.5 * kWholeTurn : kWholeTurn;
    const auto place = [&](int k) { return middle + half * static_cast<double>(k) / points; };
    const auto distance = [&](double u) { return (at(u).c - point).squaredNorm(); };
    double best = middle;
    double least = std::numeric_limits<double>::infinity();
    double before = least;
    double here = distance(place(-points));
    for (int k = -points; k <= points; ++k) {
        const double after = k < points ? distance(place(k + 1)) : std::numeric_limits<double>::infinity();
        // every local minimum is refined: the nearest sample need not lead to the nearest point
        if (here <= before && here <= after) {
            const double u = nearest(point, place(k));
            const double found = distance(u);
            if (found < least) {
                least = found;
                best = u;
            }
        }
        before = here;
        here = after;
    }
    return is_closed() ? std::remainder(best, kWholeTurn) : best;
}

double Curve::followed(const Vec3& point, double expected) const {
    constexpr double beside = 0.01;
    const double u = nearest(point, expected);
    const Point found = at(u);
    return (found.c - point).norm() < beside * found.c_u.norm() ? u : nearest(point);
}

Curve Curve::through(std::span<const Vec3> points) {
    if (points.size() < 3) { throw std::invalid_argument("a closed curve needs three points"); }
    const auto count = static_cast<double>(points.size());
    Curve curve;
    for (const Vec3& point : points) { curve.constant += point / count; }
    for (std::size_t k = 1; 2 * k <= points.size(); ++k) {
        Harmonic h;
        for (std::size_t m = 0; m < points.size(); ++m) {
            // reduced exactly, as k m may be large
            const double angle = kWholeTurn * static_cast<double>((k * m) % points.size()) / count;
            const auto [sine, cosine] = elementary::sine_and_cosine(angle);
            h.cos += 2.0 / count * cosine * points[m];
            h.sin += 2.0 / count * sine * points[m];
        }
        // with an even number of points, the highest harmonic has only a cosine, and its sum counts twice
        if (2 * k == points.size()) { h = {0.5 * h.cos, Vec3::Zero()}; }
        curve.harmonics.push_back(h);
    }
    return curve;
}

CurveComponent component_of(const Curve& curve, int component) {
    CurveComponent out{curve.constant(component), curve.linear(component), {}};
    for (const Curve::Harmonic& h : curve.harmonics) {
        out.harmonics.push_back({h.cos(component), h.sin(component)});
    }
    return out;
}

}  // namespace jw
