#include "app/session/benchmark/extrapolation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/elementary/elementary.hpp"

namespace jw {

namespace {

using Numbers = std::vector<double>;

// 2, 6, 10 ... 26 small steps: these keep the weights of the extrapolation, and so its rounding, small
constexpr std::size_t kColumns = 7;
constexpr int steps_of(std::size_t column) { return static_cast<int>(4 * column + 2); }
constexpr double kOrder = 2.0 * kColumns;

class Extrapolation {
public:
    Extrapolation(MotionEquations& equations, double tolerance)
        : equations_(equations), tolerance_(tolerance), slope_(static_cast<std::size_t>(equations.size())) {}

    /// One step of length h. @return its error relative to the tolerance; not finite if the step failed
    double step(double t, double h, Numbers& y) {
        Numbers first(y.size());
        equations_.evaluate(t, y.data(), first.data());
        Numbers error(y.size());
        for (std::size_t k = 0; k < kColumns; ++k) {
            Numbers value = midpoint_rule(t, h, y, first, steps_of(k));
            for (std::size_t m = 1; m <= k; ++m) {
                const double ratio = static_cast<double>(steps_of(k)) / steps_of(k - m);
                for (std::size_t n = 0; n < y.size(); ++n) {
                    const double correction = (value[n] - row_[m - 1][n]) / (ratio * ratio - 1.0);
                    row_[m - 1][n] = value[n];
                    value[n] += correction;
                    error[n] = correction;
                }
            }
            row_[k] = std::move(value);
        }
        double largest = 0.0;
        for (std::size_t n = 0; n < y.size(); ++n) {
            const double by_size = std::abs(error[n]) / (1.0 + std::abs(y[n]));
            if (!(by_size <= largest)) { largest = by_size; }
            y[n] += row_[kColumns - 1][n];
        }
        return largest / tolerance_;
    }

private:
    /// Change of y over `count` midpoint steps (an even number). Changes are smaller than y, and so is the
    /// rounding error.
    Numbers midpoint_rule(double t, double h, const Numbers& y, const Numbers& first, int count) {
        const double small = h / count;
        Numbers before(y.size(), 0.0);
        Numbers now(y.size());
        Numbers there(y.size());
        for (std::size_t n = 0; n < y.size(); ++n) { now[n] = small * first[n]; }
        for (int s = 1; s < count; ++s) {
            for (std::size_t n = 0; n < y.size(); ++n) { there[n] = y[n] + now[n]; }
            equations_.evaluate(t + s * small, there.data(), slope_.data());
            for (std::size_t n = 0; n < y.size(); ++n) { before[n] += 2.0 * small * slope_[n]; }
            before.swap(now);
        }
        return now;
    }

    MotionEquations& equations_;
    double tolerance_;
    Numbers slope_;
    std::array<Numbers, kColumns> row_;
};

}  // namespace

bool extrapolate(
    MotionEquations& equations, std::vector<double> y, const std::vector<double>& times, double tolerance,
    long most_steps, const std::function<void(const std::vector<double>& y)>& receive) {
    Extrapolation extrapolation(equations, tolerance);
    const double duration = times.back() - times.front();
    double h = 1e-3 * duration;
    long steps = 0;
    receive(y);
    for (std::size_t k = 1; k < times.size(); ++k) {
        double t = times[k - 1];
        while (t < times[k]) {
            if (++steps > most_steps || !(h > 1e-10 * duration)) { return false; }
            equations.choose_rows(t, y.data());
            const double left = times[k] - t;
            const bool last = h >= left;
            const double tried = last ? left : std::min(h, 0.5 * left);
            Numbers next = y;
            const double error = extrapolation.step(t, tried, next);
            const double finite = std::isfinite(error) ? std::max(error, 1e-20) : 1e20;
            const double factor = std::clamp(0.8 * elementary::pow(finite, -1.0 / (kOrder - 1.0)), 0.2, 4.0);
            if (finite > 1.0) {
                h = tried * factor;
                continue;
            }
            h = last ? std::max(h, tried * factor) : tried * factor;
            t = last ? times[k] : t + tried;
            y = std::move(next);
            equations.project(t, y.data());
        }
        receive(y);
    }
    return true;
}

}  // namespace jw
