#include "core/jets/time_function.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/elementary/elementary.hpp"

namespace jw {

namespace {

void add_polynomial(TimeFunction::Value& value, const std::vector<double>& coefficients, double t) {
    double f = 0.0;
    double f_dot = 0.0;
    double half_f_ddot = 0.0;
    for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) {
        half_f_ddot = half_f_ddot * t + f_dot;
        f_dot = f_dot * t + f;
        f = f * t + *c;
    }
    value.f += f;
    value.f_dot += f_dot;
    value.f_ddot += 2.0 * half_f_ddot;
}

void add_harmonic(TimeFunction::Value& value, const TimeFunction::Harmonic& h, double t) {
    const auto [sine, cosine] = elementary::sine_and_cosine(h.omega * t + h.phase);
    value.f += h.amplitude * sine;
    value.f_dot += h.amplitude * h.omega * cosine;
    value.f_ddot -= h.omega * h.omega * (h.amplitude * sine);
}

void add_step(TimeFunction::Value& value, const TimeFunction::SmoothStep& step, double t) {
    const double duration = step.end - step.start;
    const double u = (t - step.start) / duration;
    if (u <= 0.0) {
        value.f += step.from;
        return;
    }
    if (u >= 1.0) {
        value.f += step.to;
        return;
    }
    const double rise = step.to - step.from;
    value.f += step.from + rise * u * u * u * (10.0 + u * (-15.0 + 6.0 * u));
    value.f_dot += rise * 30.0 * u * u * (1.0 - u) * (1.0 - u) / duration;
    value.f_ddot += rise * 60.0 * u * (1.0 - u) * (1.0 - 2.0 * u) / (duration * duration);
}

void add_table(TimeFunction::Value& value, const TimeTable& table, double t) {
    const auto [start, c] = table.piece_at(t);
    const double u = t - start;
    value.f += c[0] + u * (c[1] + u * (c[2] + u * c[3]));
    value.f_dot += c[1] + u * (2.0 * c[2] + u * 3.0 * c[3]);
    value.f_ddot += 2.0 * c[2] + u * 6.0 * c[3];
}

void add_formula(TimeFunction::Value& value, const TimeFormula& formula, double t) {
    const auto [f, f_dot, half_f_ddot] = formula.taylor_at(t);
    value.f += f;
    value.f_dot += f_dot;
    value.f_ddot += 2.0 * half_f_ddot;
}

using TaylorBounds = std::array<double, 5>;

void bound_polynomial(TaylorBounds& bounds, const std::vector<double>& coefficients, double largest_t) {
    TaylorBounds sum{};
    for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) {
        for (std::size_t k = sum.size() - 1; k > 0; --k) { sum[k] = sum[k] * largest_t + sum[k - 1]; }
        sum[0] = sum[0] * largest_t + std::abs(*c);
    }
    for (std::size_t k = 1; k < sum.size(); ++k) { bounds[k] += sum[k]; }
}

void bound_harmonic(TaylorBounds& bounds, const TimeFunction::Harmonic& h) {
    double coefficient = std::abs(h.amplitude);
    for (std::size_t k = 1; k < bounds.size(); ++k) {
        coefficient *= std::abs(h.omega) / static_cast<double>(k);
        bounds[k] += coefficient;
    }
}

void bound_step(TaylorBounds& bounds, const TimeFunction::SmoothStep& step, double from, double to) {
    if (to <= step.start || from >= step.end || step.from == step.to) { return; }
    const bool is_within = from >= step.start && to <= step.end;
    const double duration = step.end - step.start;
    // largest derivatives of 6u^5 - 15u^4 + 10u^3: 15/8, 10/sqrt(3), 60 and 360
    const double largest[] = {0.0, 1.875, 5.7736, 60.0, is_within ? 360.0 : HUGE_VAL};
    double coefficient = std::abs(step.to - step.from);
    for (std::size_t k = 1; k < bounds.size(); ++k) {
        coefficient /= duration * static_cast<double>(k);
        bounds[k] += coefficient * largest[k];
    }
}

}  // namespace

std::array<double, 5> TimeFunction::taylor_bounds(double from, double to) const {
    TaylorBounds bounds{};
    bound_polynomial(bounds, polynomial, std::max(std::abs(from), std::abs(to)));
    for (const Harmonic& harmonic : harmonics) { bound_harmonic(bounds, harmonic); }
    for (const SmoothStep& step : steps) { bound_step(bounds, step, from, to); }
    const auto add = [&](const TaylorBounds& part) {
        std::ranges::transform(bounds, part, bounds.begin(), std::plus<>());
    };
    if (table) { add(table->taylor_bounds(from, to)); }
    if (formula) { add(formula->taylor_bounds(from, to)); }
    return bounds;
}

void TimeFunction::append_kinks(std::vector<double>& times) const {
    for (const SmoothStep& step : steps) { times.insert(times.end(), {step.start, step.end}); }
    if (table) { times.insert(times.end(), table->times.begin(), table->times.end()); }
}

TimeFunction::Value TimeFunction::at(double t) const {
    Value value;
    add_polynomial(value, polynomial, t);
    for (const Harmonic& harmonic : harmonics) { add_harmonic(value, harmonic, t); }
    for (const SmoothStep& step : steps) { add_step(value, step, t); }
    if (table) { add_table(value, *table, t); }
    if (formula) { add_formula(value, *formula, t); }
    return value;
}

}  // namespace jw
