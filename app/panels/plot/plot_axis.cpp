#include "app/panels/plot/plot_axis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "app/session/wording/numbers.hpp"

namespace jw::panels {

namespace {

constexpr double kMargin = 0.06;             // of the range, above and below the curves
constexpr double kSlack = 1e-9;              // of a step: ticks at the very end of an axis count
constexpr double kRelativeRounding = 1e-12;  // of the values: closer numbers count as the same
constexpr double kLargest = 1e300;           // margins must not overflow
constexpr double kWidestPlain = 1e5;         // larger numbers are shown with a power of ten
constexpr double kNarrowestPlain = 1e-3;     // and so are smaller ones

/// Steps that divide a turn, in degrees.
constexpr std::array kDegreeSteps{15.0, 30.0, 45.0, 90.0, 180.0, 360.0, 720.0, 1800.0, 3600.0};

double step_in_degrees(double length, int most) {
    const double decimal = nice_step(length, most);
    if (decimal < kDegreeSteps.front() * 0.5 || decimal > kDegreeSteps.back()) { return decimal; }
    for (const double step : kDegreeSteps) {
        if (length / step <= most) { return step; }
    }
    return decimal;
}

/// Exponent with which the largest number has one to three figures before the point; 0 if it needs none.
int handy_exponent(double largest) {
    if (largest == 0.0 || (largest < kWidestPlain && largest >= kNarrowestPlain)) { return 0; }
    return 3 * static_cast<int>(std::floor(std::log10(largest) / 3.0 + kSlack));
}

int decimals_of(double step) { return std::max(0, static_cast<int>(std::ceil(-std::log10(step) - kSlack))); }

TickMarks ticks_every(const Range& range, double step, int exponent) {
    const double unit = std::pow(10.0, exponent);
    const int decimals = decimals_of(step / unit);
    const double first = std::ceil(range.from / step - kSlack);
    TickMarks marks{{}, exponent};
    for (int k = 0; (first + k) * step <= range.to + kSlack * step; ++k) {
        const double at = (first + k) * step;
        marks.ticks.push_back({at, fixed_text(at / unit, decimals)});
    }
    return marks;
}

TickMarks linear_ticks(const Axis& axis, int most, Ticks kind) {
    const Range& range = axis.range;
    const double size = std::max(std::abs(range.from), std::abs(range.to));
    const int exponent = kind == Ticks::whole ? 0 : handy_exponent(size);
    TickMarks marks;
    // with only one number, the scale of the axis cannot be read
    for (int steps = most; marks.ticks.size() < 2 && steps < most + 4; ++steps) {
        double step = kind == Ticks::degrees ? step_in_degrees(range.length(), steps)
                                             : nice_step(range.length(), steps);
        if (kind == Ticks::whole) { step = std::max(1.0, step); }
        marks = ticks_every(range, step, exponent);
    }
    return marks;
}

/// 1, 2 and 5 times every power of ten, as plain numbers; for ranges with fewer than three powers.
std::vector<Tick> ticks_within_powers(const Range& range) {
    std::vector<Tick> ticks;
    const int low = static_cast<int>(std::floor(std::log10(range.from)));
    const int high = static_cast<int>(std::ceil(std::log10(range.to)));
    for (int power = low; power <= high; ++power) {
        for (const double digit : {1.0, 2.0, 5.0}) {
            const double at = digit * std::pow(10.0, power);
            const bool plain = power >= -3 && power < 5;
            if (!range.contains(at)) { continue; }
            ticks.push_back({at, plain ? number_text(at) : small_text(at)});
        }
    }
    return ticks;
}

TickMarks log_ticks(const Axis& axis, int most) {
    const int low = static_cast<int>(std::ceil(std::log10(axis.range.from) - kSlack));
    const int high = static_cast<int>(std::floor(std::log10(axis.range.to) + kSlack));
    if (high - low < 2) {
        std::vector<Tick> ticks = ticks_within_powers(axis.range);
        // within less than a power of ten, the scale is nearly linear
        if (ticks.size() < 3) {
            Axis even = axis;
            even.logarithmic = false;
            return linear_ticks(even, std::min(most, 4), Ticks::decimal);
        }
        if (static_cast<int>(ticks.size()) <= most) { return {std::move(ticks), 0}; }
    }
    TickMarks marks;
    const int every = std::max(1, (high - low) / std::max(1, most) + 1);
    // multiples of `every`, so that the numbers do not depend on the range
    for (int power = low; power <= high; ++power) {
        const bool named = ((power % every) + every) % every == 0 || high - low < every;
        if (named) { marks.ticks.push_back({std::pow(10.0, power), power_of_ten(power)}); }
    }
    return marks;
}

}  // namespace

float Axis::pixel(double value) const {
    double part = 0.0;
    if (!logarithmic) {
        part = (value - range.from) / range.length();
    } else if (value > 0.0) {
        part = std::log(value / range.from) / std::log(range.to / range.from);
        part = std::max(part, 0.0);
    }
    // pixels far outside of the picture need not be exact
    constexpr double far = 1e6;
    return start + static_cast<float>(std::clamp(part * (end - start), -far, far));
}

double Axis::value(float pixel) const {
    const double part = static_cast<double>(pixel - start) / static_cast<double>(end - start);
    return logarithmic ? range.from * std::pow(range.to / range.from, part)
                       : range.from + part * range.length();
}

Axis axis_of_powers(const std::vector<double>& values, int low, float start, float end) {
    double largest = 0.0;
    for (const double value : values) {
        if (std::isfinite(value)) { largest = std::max(largest, value); }
    }
    int high = low + 2;
    // a value just above a power of ten, by rounding, does not need the next power
    if (largest > 0.0) { high = std::max(high, static_cast<int>(std::ceil(std::log10(largest) - kSlack))); }
    high = std::min(high, std::numeric_limits<double>::max_exponent10);
    return {{std::pow(10.0, low), std::pow(10.0, high)}, true, start, end};
}

double nice_step(double length, int most) {
    const double least = length / std::max(1, most);
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double digit : {1.0, 2.0, 5.0}) {
        if (digit * power >= least * (1.0 - kSlack)) { return digit * power; }
    }
    return 10.0 * power;
}

TickMarks ticks_of(const Axis& axis, int most, Ticks kind) {
    most = std::max(1, most);
    return axis.logarithmic ? log_ticks(axis, most) : linear_ticks(axis, most, kind);
}

std::string power_of_ten(int exponent) {
    static constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = exponent < 0 ? "10⁻" : "10";
    for (const char c : std::to_string(std::abs(exponent))) { text += digits[c - '0']; }
    return text;
}

Range range_around(const Range& values, double rounding) {
    const double from = std::clamp(values.from, -kLargest, kLargest);
    const double to = std::clamp(values.to, -kLargest, kLargest);
    const double size = std::max(std::abs(from), std::abs(to));
    if (to - from <= std::max(rounding, kRelativeRounding * size)) {
        const double middle = 0.5 * (from + to);
        const bool zero = size <= std::max(10.0 * rounding, 1.0 / kLargest);
        const double half = zero ? 1.0 : 0.5 * size;
        return zero ? Range{-half, half} : Range{middle - half, middle + half};
    }
    const double margin = kMargin * (to - from);
    return {from - margin, to + margin};
}

Range log_range_around(const Range& values) {
    // at least a factor of two, so that small differences do not look large
    const double factor = std::max(values.to / values.from, 2.0);
    const double middle = std::sqrt(values.from) * std::sqrt(values.to);
    const double half = std::pow(factor, 0.5 + kMargin);
    return {middle / half, middle * half};
}

}  // namespace jw::panels
