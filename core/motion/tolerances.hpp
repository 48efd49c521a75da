#pragma once

/// Ranges of the settings of an integration.
namespace jw {

/// Tightest tolerance (beyond the precision of a double), loosest tolerance (no digit is left), and the
/// default.
inline constexpr double kLeastTolerance = 1e-15;
inline constexpr double kMostTolerance = 0.1;
inline constexpr double kUsualTolerance = 1e-6;
inline constexpr bool is_tolerance(double x) { return x >= kLeastTolerance && x <= kMostTolerance; }
inline constexpr const char* kToleranceRange = "expected 1e-15 to 0.1";

/// Largest number of fixed steps that a run may ask for.
inline constexpr double kMostFixedSteps = 1e7;
/// Number of steps after which a run is given up; more than kMostFixedSteps, since rounding may add some.
inline constexpr long kMostStepsTaken = 11'000'000;

}  // namespace jw
