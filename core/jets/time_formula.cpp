#include "core/jets/time_formula.hpp"

#include <algorithm>
#include <cmath>

#include "core/jets/evaluate_steps.hpp"

namespace jw {

namespace {

// parts of an interval that are examined before a proof is given up: a second or two
constexpr int kMostParts = 200000;
// shortest part that is examined, and shortest swing that is looked for, relative to the interval
constexpr double kShortestPart = 1e-9;
constexpr double kShortestSwing = 1e-5;
constexpr int kSamples = 200;
constexpr double kNoSwing = 1e-6;
constexpr double kNothing = 1e-100;

/// Taylor coefficients of a formula over t.
template <class S, std::size_t N>
Taylor<S, N> coefficients(const TimeFormula& formula, const S& t) {
    const std::array variables{Taylor<S, N>::variable(t)};
    auto out = formula_steps::evaluated<Taylor<S, N>>(formula.formula.steps, variables);
    for (S& c : out.c) { c = c * S(formula.unit); }
    return out;
}

Interval between(double a, double b) { return {std::min(a, b), std::max(a, b)}; }

double middle_of(const Interval& part) { return 0.5 * (part.low + part.high); }

/// Calls `is_done` with parts of an interval in ascending order; halves each part until it returns true.
template <class F>
void look_at_parts(const Interval& whole, F&& is_done) {
    std::vector<Interval> open{whole};
    while (!open.empty()) {
        const Interval part = open.back();
        open.pop_back();
        if (is_done(part)) { continue; }
        open.push_back({middle_of(part), part.high});
        open.push_back({part.low, middle_of(part)});
    }
}

}  // namespace

std::array<double, 3> TimeFormula::taylor_at(double t) const { return coefficients<double, 3>(*this, t).c; }

std::array<double, 5> TimeFormula::taylor_bounds(double from, double to) const {
    const auto bounds = coefficients<Interval, 5>(*this, between(from, to));
    std::array<double, 5> out{};
    std::ranges::transform(bounds.c, out.begin(), [](const Interval& x) { return x.magnitude(); });
    return out;
}

std::optional<double> TimeFormula::gap_between(double from, double to) const {
    const double shortest = kShortestPart * (to - from);
    std::optional<double> gap;
    int parts = 0;
    look_at_parts({from, to}, [&](const Interval& part) {
        if (gap) { return true; }
        const bool is_last = part.high - part.low <= shortest || parts > kMostParts;
        ++parts;
        const auto bounds = coefficients<Interval, 3>(*this, part);
        if (std::ranges::all_of(bounds.c, &Interval::is_bounded)) { return true; }
        if (!is_last) { return false; }
        gap = part.low == from ? from : part.high == to ? to : middle_of(part);
        return true;
    });
    return gap;
}

void TimeFormula::append_swings(double from, double to, std::vector<double>& times) const {
    double low = HUGE_VAL;
    double high = -HUGE_VAL;
    for (int k = 0; k <= kSamples; ++k) {
        const double value = taylor_at(from + (to - from) * k / kSamples)[0];
        low = std::min(low, value);
        high = std::max(high, value);
    }
    // a sin(ω t), of size a, has a fourth coefficient of a ω⁴ / 24, which is 4 a / h⁴ for half a period h;
    // a variation of at most a millionth of the size of the formula is not a swing and may be rounding
    const double size = taylor_bounds(from, to)[0];
    const double most = 4.0 * 0.5 * (high - low) + kNoSwing * (std::isfinite(size) ? size : 0.0) + kNothing;
    look_at_parts({from, to}, [&](const Interval& part) {
        const double h = part.high - part.low;
        const double fourth = taylor_bounds(part.low, part.high)[4];
        if (fourth * h * h * h * h > most && h > kShortestSwing * (to - from)) { return false; }
        times.push_back(part.high);
        return true;
    });
}

}  // namespace jw
