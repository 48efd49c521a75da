#pragma once

#include <cmath>

#include "tests/reference/real.hpp"

/// Functions of time up to the second derivative: what a constraint equation needs for its rate and for γ.
namespace jw::reference::general {

/// f(t + τ) = value + rate τ + second τ²/2.
struct Taylor {
    Real value = 0.0L;
    Real rate = 0.0L;
    Real second = 0.0L;
};

inline Taylor operator+(const Taylor& a, const Taylor& b) {
    return {a.value + b.value, a.rate + b.rate, a.second + b.second};
}
inline Taylor operator-(const Taylor& a, const Taylor& b) {
    return {a.value - b.value, a.rate - b.rate, a.second - b.second};
}
inline Taylor operator*(const Taylor& a, const Taylor& b) {
    return {
        a.value * b.value, a.rate * b.value + a.value * b.rate,
        a.second * b.value + 2.0L * a.rate * b.rate + a.value * b.second};
}
inline Taylor operator*(Real k, const Taylor& a) { return {k * a.value, k * a.rate, k * a.second}; }

/// Angle of the point (x, y): with ρ² = x² + y², ρ² θ̇ = x ẏ - y ẋ; that line differentiated gives θ̈.
inline Taylor angle_of(const Taylor& y, const Taylor& x) {
    const Real square = x.value * x.value + y.value * y.value;
    const Real rate = (x.value * y.rate - y.value * x.rate) / square;
    const Real square_rate = 2.0L * (x.value * x.rate + y.value * y.rate);
    const Real second = (x.value * y.second - y.value * x.second - square_rate * rate) / square;
    return {std::atan2(y.value, x.value), rate, second};
}

/// A vector as a function of time.
struct TaylorVector {
    Vec3 value = Vec3::Zero();
    Vec3 rate = Vec3::Zero();
    Vec3 second = Vec3::Zero();

    Taylor operator[](Eigen::Index k) const { return {value[k], rate[k], second[k]}; }
};

inline TaylorVector operator-(const TaylorVector& a, const TaylorVector& b) {
    return {a.value - b.value, a.rate - b.rate, a.second - b.second};
}
inline TaylorVector operator+(const TaylorVector& a, const TaylorVector& b) {
    return {a.value + b.value, a.rate + b.rate, a.second + b.second};
}
inline Taylor dot(const TaylorVector& a, const TaylorVector& b) {
    return {
        a.value.dot(b.value), a.rate.dot(b.value) + a.value.dot(b.rate),
        a.second.dot(b.value) + 2.0L * a.rate.dot(b.rate) + a.value.dot(b.second)};
}
inline TaylorVector cross(const TaylorVector& a, const TaylorVector& b) {
    return {
        a.value.cross(b.value), a.rate.cross(b.value) + a.value.cross(b.rate),
        a.second.cross(b.value) + 2.0L * a.rate.cross(b.rate) + a.value.cross(b.second)};
}

}  // namespace jw::reference::general
