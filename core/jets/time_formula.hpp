#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/jets/formula_steps.hpp"

/// A function of time that an author writes as a formula.
namespace jw {

struct TimeFormula {
    ScalarFormula formula;  ///< of the time t [s], its only variable
    double unit = 1.0;      ///< factor of its value: π/180 for a formula in degrees

    /// Taylor coefficients f, f', f'' / 2 at t; not finite where the formula has no value.
    std::array<double, 3> taylor_at(double t) const;
    /// Bounds between two times: entry k bounds |f^(k)| / k!; entry 0 bounds |f|. Infinite where the formula
    /// has no value, or cannot be bounded.
    std::array<double, 5> taylor_bounds(double from, double to) const;
    /// A time between two others at which value, rate or acceleration do not exist or could not be bounded;
    /// nothing if they exist everywhere.
    std::optional<double> gap_between(double from, double to) const;
    /// Appends times between which the formula is nearly a cubic: at most half a period apart where it swings
    /// like a sine. An integration method whose steps end at these times does not miss a swing.
    void append_swings(double from, double to, std::vector<double>& times) const;

    bool operator==(const TimeFormula&) const = default;
};

}  // namespace jw
