#pragma once

#include <string>
#include <vector>

/// Axes of plots: conversion between values and pixels, and places of numbers.
namespace jw::panels {

struct Range {
    double from = 0.0;
    double to = 1.0;

    double length() const { return to - from; }
    bool contains(double value) const { return value >= from && value <= to; }
    bool operator==(const Range&) const = default;
};

struct Axis {
    Range range;
    bool logarithmic = false;  ///< then range.from > 0
    float start = 0.0F;        ///< pixel of range.from
    float end = 1.0F;          ///< pixel of range.to; smaller than `start` on a vertical axis

    /// On a logarithmic axis, values of zero and below are at `start`.
    float pixel(double value) const;
    double value(float pixel) const;
};

struct Tick {
    double at = 0.0;
    std::string text;  ///< empty: a line without a number
};

/// Axis of whole powers of ten, from 10^low to the largest of `values`, but at least over two powers.
Axis axis_of_powers(const std::vector<double>& values, int low, float start, float end);

/// Kind of numbers that a plot may show on an axis.
enum class Ticks {
    decimal,  ///< steps of 1, 2, 5
    degrees,  ///< steps of 15, 30, 45, 90 ... if they are large enough
    whole,    ///< whole numbers only
};

struct TickMarks {
    std::vector<Tick> ticks;
    int exponent = 0;  ///< numbers are shown divided by 10 to this power
};

/// Round numbers within the range, at most `most`, and at least two if possible.
TickMarks ticks_of(const Axis& axis, int most, Ticks kind = Ticks::decimal);

/// The smallest of 1, 2, 5 times a power of ten that divides `length` into at most `most` steps.
double nice_step(double length, int most);

/// "10⁻³"
std::string power_of_ten(int exponent);

/// Range around `values` with a margin, so that curves do not run along the edge. Values whose range is not
/// longer than `rounding` count as constant, and get room on both sides.
Range range_around(const Range& values, double rounding);
/// Range around values on a logarithmic scale; `values.from` > 0.
Range log_range_around(const Range& values);

}  // namespace jw::panels
