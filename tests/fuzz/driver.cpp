#include <cmath>

#include "lessons/read/reader.hpp"
#include "tests/fuzz/targets.hpp"

namespace jw::fuzz {

namespace {

constexpr const char* kScene = R"(format = 1
title = "driven"
[[body]]
name = "base"
[[body]]
name = "arm"
[[joint]]
name = "pin"
type = "revolute"
bodies = ["base", "arm"]
at = [0, 0, 0]
axis = [0, 0, 1]
side_i = [1, 0, 0]
side_j = [1, 0, 0]
[motion]
from_s = 0
to_s = 2
[[driver]]
name = "motor"
quantity = "pin.angle"
)";
constexpr int kMoments = 20;

/// Sum of the sizes of all terms and of their third derivatives, at times up to 2 s: rounding and truncation
/// of differences are proportional to it.
double size_of(const TimeFunction& function) {
    double size = 1.0;
    for (std::size_t k = 0; k < function.polynomial.size(); ++k) {
        const auto power = static_cast<double>(k);
        size += std::abs(function.polynomial[k]) * std::pow(2.0, power) * (1.0 + power * power * power);
    }
    for (const auto& h : function.harmonics) {
        size += std::abs(h.amplitude) * (1.0 + std::pow(std::abs(h.omega), 3));
    }
    if (function.table) {
        for (std::size_t k = 0; k <= function.table->times.size(); ++k) {
            for (const double c : function.table->piece(k).c) { size += 100.0 * std::abs(c); }
        }
    }
    if (function.formula) { size += 100.0 * function.formula->taylor_bounds(0.0, 2.0)[3]; }
    for (const auto& s : function.steps) {
        size += (std::abs(s.from) + std::abs(s.to)) * (1.0 + 60.0 * std::pow(s.end - s.start, -3));
    }
    return size;
}

/// Promises that the change of the function over 2h agrees with its rate in the middle: they differ by
/// h² f‴ / 6 and by rounding, eps f / h.
void promise_derivatives(const TimeFunction& function, double t) {
    constexpr double h = 1e-5;
    const TimeFunction::Value before = function.at(t - h);
    const TimeFunction::Value here = function.at(t);
    const TimeFunction::Value after = function.at(t + h);
    for (const double x : {here.f, here.f_dot, here.f_ddot}) {
        promise(std::isfinite(x), "a value is finite");
    }
    // the second derivative of a table may jump at its times: a difference is then wrong in proportion to h
    const bool at_jump = function.table && std::ranges::any_of(function.table->times, [&](double time) {
                             return std::abs(time - t) < 2.0 * h;
                         });
    const double limit = (at_jump ? h : 1e-9) * size_of(function);
    promise(std::abs((after.f - before.f) / (2 * h) - here.f_dot) < limit, "the rate is the derivative");
    // the third derivative of a step jumps at both its ends: a difference is then wrong in proportion to h
    const double bent = function.steps.empty() && !at_jump ? limit : (at_jump ? 1.0 : h) * size_of(function);
    promise(std::abs((after.f_dot - before.f_dot) / (2 * h) - here.f_ddot) < bent, "so is the acceleration");
}

}  // namespace

/// Checks keys of a driver as they are written in a lesson.
bool check_driver(const std::string& input) {
    const ReadResult read = read_lesson(kScene + input, "driver.toml");
    if (!read.lesson || read.lesson->mechanism.drivers.empty()) { return false; }
    for (const Driver& driver : read.lesson->mechanism.drivers) {
        for (int k = 0; k <= kMoments; ++k) { promise_derivatives(driver.function, 2.0 * k / kMoments); }
    }
    return true;
}

}  // namespace jw::fuzz
