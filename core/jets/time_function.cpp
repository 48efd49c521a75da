#include "core/jets/time_function.hpp"

#include <cmath>

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

}  // namespace

TimeFunction::Value TimeFunction::at(double t) const {
    Value value;
    add_polynomial(value, polynomial, t);
    for (const Harmonic& harmonic : harmonics) { add_harmonic(value, harmonic, t); }
    for (const SmoothStep& step : steps) { add_step(value, step, t); }
    return value;
}

}  // namespace jw
