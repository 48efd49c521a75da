#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/jets/time_formula.hpp"
#include "core/jets/time_table.hpp"

/// A function of time with its two derivatives, for drivers.
namespace jw {

/// Sum of a polynomial, harmonics, smooth steps, a table and a formula; every part may be absent.
struct TimeFunction {
    struct Harmonic {
        double amplitude = 0.0;
        double omega = 0.0;  ///< [rad/s]
        double phase = 0.0;  ///< [rad]

        bool operator==(const Harmonic&) const = default;
    };
    /// Step from `from` before `start` to `to` after `end` along 6u⁵ - 15u⁴ + 10u³: two continuous
    /// derivatives.
    struct SmoothStep {
        double from = 0.0;
        double to = 0.0;
        double start = 0.0;  ///< [s]
        double end = 1.0;    ///< [s], > start

        bool operator==(const SmoothStep&) const = default;
    };
    struct Value {
        double f = 0.0;
        double f_dot = 0.0;
        double f_ddot = 0.0;
    };

    std::vector<double> polynomial = {};   ///< c0 + c1 t + c2 t² + ...
    std::vector<Harmonic> harmonics = {};  ///< Σ a sin(ω t + phase)
    std::vector<SmoothStep> steps = {};
    std::optional<TimeTable> table = {};
    std::optional<TimeFormula> formula = {};

    Value at(double t) const;
    /// Appends the times at which a smooth step begins or ends, and those of the table.
    void append_kinks(std::vector<double>& times) const;
    /// Bounds between two times: entry k bounds |f^(k)| / k!; entry 0 is not used. Where a smooth step begins
    /// or ends between them, its third derivative jumps, and the fourth has no bound; likewise at the times
    /// of a table, whose second derivative may jump as well.
    std::array<double, 5> taylor_bounds(double from, double to) const;

    /// True if its second derivative jumps at some times: integration methods lose their order there.
    bool acceleration_jumps() const {
        return table && table->interpolation == TimeTable::Interpolation::monotone;
    }

    bool operator==(const TimeFunction&) const = default;
};

}  // namespace jw
