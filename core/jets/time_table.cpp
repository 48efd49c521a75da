#include "core/jets/time_table.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

namespace jw {

namespace {

using Numbers = std::vector<double>;

std::size_t index_of(const Numbers& times, Numbers::const_iterator time) {
    return static_cast<std::size_t>(std::distance(times.begin(), time));
}

Numbers differences(const Numbers& of) {
    Numbers out;
    for (std::size_t k = 1; k < of.size(); ++k) { out.push_back(of[k] - of[k - 1]); }
    return out;
}

/// Rates m of the natural cubic spline. Equal second derivatives on both sides of time k mean
/// m[k-1] / h[k-1] + 2 (1 / h[k-1] + 1 / h[k]) m[k] + m[k+1] / h[k] = 3 (d[k-1] / h[k-1] + d[k] / h[k]), and
/// zero ones at the ends mean 2 m[0] + m[1] = 3 d[0]: a tridiagonal system whose diagonal dominates.
/// @param h  time between two values [s]  @param d  mean rate between them
Numbers smooth_rates(const Numbers& h, const Numbers& d) {
    const std::size_t last = h.size();
    Numbers m(last + 1);
    Numbers above(last + 1);  // entry above the diagonal after elimination; the diagonal is 1
    for (std::size_t k = 0; k <= last; ++k) {
        const double before = k > 0 ? 1.0 / h[k - 1] : 0.0;
        const double after = k < last ? 1.0 / h[k] : 0.0;
        const double right = 3.0 * ((k > 0 ? d[k - 1] * before : 0.0) + (k < last ? d[k] * after : 0.0));
        const double diagonal = 2.0 * (before + after) - (k > 0 ? before * above[k - 1] : 0.0);
        above[k] = after / diagonal;
        m[k] = (right - (k > 0 ? before * m[k - 1] : 0.0)) / diagonal;
    }
    for (std::size_t k = last; k-- > 0;) { m[k] -= above[k] * m[k + 1]; }
    return m;
}

/// Rate at an end by the parabola through three values, limited so that the piece stays monotone.
double monotone_end(double h, double h_next, double d, double d_next) {
    const double rate = ((2.0 * h + h_next) * d - h * d_next) / (h + h_next);
    if (rate * d <= 0.0) { return 0.0; }
    return d * d_next <= 0.0 && std::abs(rate) > 3.0 * std::abs(d) ? 3.0 * d : rate;
}

/// Rates: weighted harmonic means of the mean rates on both sides of each time; 0 where these differ in sign.
/// @source Fritsch and Butland, "A method for constructing local monotone piecewise cubic interpolants"
/// (1984)
Numbers monotone_rates(const Numbers& h, const Numbers& d) {
    const std::size_t last = h.size();
    Numbers m(last + 1, d.front());
    if (last == 1) { return m; }
    m[0] = monotone_end(h[0], h[1], d[0], d[1]);
    m[last] = monotone_end(h[last - 1], h[last - 2], d[last - 1], d[last - 2]);
    for (std::size_t k = 1; k < last; ++k) {
        const double before = h[k - 1] + 2.0 * h[k];
        const double after = 2.0 * h[k - 1] + h[k];
        const bool turns = d[k - 1] * d[k] <= 0.0;
        m[k] = turns ? 0.0 : (before + after) / (before / d[k - 1] + after / d[k]);
    }
    return m;
}

/// Bounds of |f^(k)| / k! of a piece up to a time: the sum of |c_n| binomial(n, k) u^(n - k) over n, with u
/// the time since its start; c_2 and c_3 are 0 in the pieces before and after all times.
std::array<double, 4> bounds_up_to(const CubicPiece& piece, double t) {
    const double u = t - piece.start;
    const double c1 = std::abs(piece.c[1]);
    const double c2 = std::abs(piece.c[2]);
    const double c3 = std::abs(piece.c[3]);
    return {0.0, c1 + u * (2.0 * c2 + u * 3.0 * c3), c2 + u * 3.0 * c3, c3};
}

}  // namespace

CubicPiece TimeTable::piece(std::size_t k) const {
    if (k == 0) { return {times.front(), {values.front(), rates.front(), 0.0, 0.0}}; }
    if (k == times.size()) { return {times.back(), {values.back(), rates.back(), 0.0, 0.0}}; }
    const double h = times[k] - times[k - 1];
    const double mean = (values[k] - values[k - 1]) / h;
    const double bend = rates[k - 1] + rates[k] - 2.0 * mean;
    return {times[k - 1], {values[k - 1], rates[k - 1], (mean - rates[k - 1] - bend) / h, bend / (h * h)}};
}

CubicPiece TimeTable::piece_at(double t) const {
    if (t == times.back()) { return piece(times.size() - 1); }
    return piece(index_of(times, std::ranges::upper_bound(times, t)));
}

std::array<double, 5> TimeTable::taylor_bounds(double from, double to) const {
    const auto first = index_of(times, std::ranges::upper_bound(times, from));
    const auto until = index_of(times, std::ranges::lower_bound(times, to));
    const std::size_t last = std::max(first, until);
    std::array<double, 5> bounds{};
    for (std::size_t k = first; k <= last; ++k) {
        const std::array<double, 4> of_piece = bounds_up_to(piece(k), k < last ? times[k] : to);
        for (std::size_t n = 1; n < of_piece.size(); ++n) { bounds[n] = std::max(bounds[n], of_piece[n]); }
    }
    if (last > first) {
        bounds[4] = HUGE_VAL;
        if (interpolation == Interpolation::monotone) { bounds[3] = HUGE_VAL; }
    }
    return bounds;
}

TimeTable table_through(Numbers times, Numbers values, TimeTable::Interpolation interpolation) {
    const Numbers h = differences(times);
    if (times.size() < 2 || times.size() != values.size() || !(std::ranges::min(h) > 0.0)) {
        throw std::invalid_argument(
            "a table of " + std::to_string(times.size()) + " times and " + std::to_string(values.size()) +
            " values; expected at least two increasing times with a value each");
    }
    Numbers d = differences(values);
    std::ranges::transform(d, h, d.begin(), std::divides<>());
    const bool is_smooth = interpolation == TimeTable::Interpolation::smooth;
    Numbers rates = is_smooth ? smooth_rates(h, d) : monotone_rates(h, d);
    return {interpolation, std::move(times), std::move(values), std::move(rates)};
}

}  // namespace jw
