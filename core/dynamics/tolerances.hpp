#pragma once

/// What an integration can sensibly be asked for.
namespace jw {

/// Beyond the digits that doubles have, and so loose that no digit is left.
inline constexpr double kLeastTolerance = 1e-15;
inline constexpr double kMostTolerance = 0.1;
inline constexpr bool is_tolerance(double x) { return x >= kLeastTolerance && x <= kMostTolerance; }
inline constexpr const char* kToleranceRange = "expected 1e-15 to 0.1";

/// Steps of equal length that a run may ask for.
inline constexpr double kMostFixedSteps = 1e7;
/// Steps after which a run is given up: more, as rounding may add some.
inline constexpr long kMostStepsTaken = 11'000'000;

}  // namespace jw
