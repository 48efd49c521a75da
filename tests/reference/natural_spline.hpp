#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/LU>

/// The natural cubic spline by its second derivatives, where the program solves for its first.
namespace jw::reference {

/// Value, first and second derivative. Beyond the ends the rate is constant.
template <class Real>
std::array<Real, 3> natural_spline_at(
    const std::vector<double>& times, const std::vector<double>& values, Real t) {
    using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
    using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
    const auto n = static_cast<Eigen::Index>(times.size());
    const auto x = [&](Eigen::Index k) { return Real(times[static_cast<std::size_t>(k)]); };
    const auto y = [&](Eigen::Index k) { return Real(values[static_cast<std::size_t>(k)]); };
    const auto slope = [&](Eigen::Index k) { return (y(k + 1) - y(k)) / (x(k + 1) - x(k)); };
    Matrix rows = Matrix::Identity(n, n);
    Vector right = Vector::Zero(n);
    for (Eigen::Index k = 1; k + 1 < n; ++k) {
        rows(k, k - 1) = x(k) - x(k - 1);
        rows(k, k) = 2 * (x(k + 1) - x(k - 1));
        rows(k, k + 1) = x(k + 1) - x(k);
        right(k) = 6 * (slope(k) - slope(k - 1));
    }
    const Vector bend = rows.fullPivLu().solve(right);
    const auto rate_at = [&](Eigen::Index k) {
        const Eigen::Index of = k + 1 < n ? k : n - 2;
        const Real h = x(of + 1) - x(of);
        return k + 1 < n ? slope(of) - h * (2 * bend(of) + bend(of + 1)) / 6
                         : slope(of) + h * (bend(of) + 2 * bend(of + 1)) / 6;
    };
    if (t < x(0)) { return {y(0) + rate_at(0) * (t - x(0)), rate_at(0), Real(0)}; }
    if (t >= x(n - 1)) { return {y(n - 1) + rate_at(n - 1) * (t - x(n - 1)), rate_at(n - 1), Real(0)}; }
    Eigen::Index k = 0;
    while (t >= x(k + 1)) { ++k; }
    const Real h = x(k + 1) - x(k);
    const Real a = (x(k + 1) - t) / h;
    const Real b = (t - x(k)) / h;
    return {
        a * y(k) + b * y(k + 1) + ((a * a * a - a) * bend(k) + (b * b * b - b) * bend(k + 1)) * h * h / 6,
        slope(k) + ((1 - 3 * a * a) * bend(k) + (3 * b * b - 1) * bend(k + 1)) * h / 6,
        a * bend(k) + b * bend(k + 1)};
}

template <class Real>
Real natural_spline(const std::vector<double>& times, const std::vector<double>& values, Real t) {
    return natural_spline_at<Real>(times, values, t)[0];
}

}  // namespace jw::reference
