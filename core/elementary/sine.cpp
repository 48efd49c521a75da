#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "core/elementary/elementary.hpp"
#include "core/elementary/remainder.hpp"

namespace jw::elementary {

namespace {

/// Steps of the table in one radian: sin(a + b) = sin a cos b + cos a sin b with b of at most 2^-8, so that
/// roundings of the terms added to sin a are far below its last place.
constexpr int kSineSteps = 128;
/// Last index of the table; its angle is slightly above π/4.
constexpr int kLastSine = 102;

/// sin, cos and -sin of an angle: each is the derivative of the previous one.
using Sines = std::array<Pair, 3>;

/// sin, cos and -sin of `angle`, by their power series.
constexpr Sines sines_at(double angle) {
    Pair sine;
    Pair cosine;
    Pair term{1.0, 0.0};
    for (int k = 0; k < 28; ++k) {
        // terms 1, x, -x²/2, -x³/6, x⁴/24 ...
        Pair& function = k % 2 == 0 ? cosine : sine;
        function = function + (k % 4 < 2 ? term : -term);
        term = term * Pair{angle, 0.0} / Pair{k + 1.0, 0.0};
    }
    return {sine, cosine, -sine};
}

/// Sines of k / kSineSteps for k from -kLastSine to kLastSine: negative k avoid branches on the sign, which
/// would be mispredicted half of the time.
constexpr auto kSines = [] {
    std::array<Sines, 2 * kLastSine + 1> table{};
    for (int k = 0; k <= kLastSine; ++k) {
        const auto [sine, cosine, negative] = sines_at(1.0 * k / kSineSteps);
        table[static_cast<std::size_t>(kLastSine - k)] = {negative, cosine, sine};
        table[static_cast<std::size_t>(kLastSine + k)] = {sine, cosine, negative};
    }
    return table;
}();

/// Angles below this count as small: their sine is the angle plus a small rest by the power series.
constexpr double kSmallAngle = 0.1875;

/// Angles below this are their own sine and tangent; this includes -0.
constexpr double kIsItsSine = 0x1p-30;

/// sin of a small angle; not normalised
Pair small_sine(const Pair& angle) {
    const double x = angle.high;
    const double z = x * x;
    const double upper = 1.0 / 362880 + z * (-1.0 / 39916800 + z * (1.0 / 6227020800));
    const double series = -1.0 / 6 + z * (1.0 / 120 + z * (-1.0 / 5040 + z * upper));
    return {x, x * z * series + angle.low * (1.0 - 0.5 * z)};
}

/// sin of the angle, or cos if `is_turned` by a quarter; not normalised
Pair quarter_sine(const Pair& angle, bool is_turned) {
    if (!is_turned && std::abs(angle.high) < kSmallAngle) { return small_sine(angle); }
    const double steps = (angle.high * kSineSteps + kRounds) - kRounds;
    const Sines& at = kSines[static_cast<std::size_t>(static_cast<int>(steps) + kLastSine)];
    const Pair& f = at[is_turned ? 1 : 0];
    const Pair& derivative = at[is_turned ? 2 : 1];
    const double b = angle.high - steps * (1.0 / kSineSteps);
    const double z = b * b;
    const double sine_less_b = b * z * (-1.0 / 6 + z * (1.0 / 120));
    const double cosine_less_one = z * (-0.5 + z * (1.0 / 24 + z * (-1.0 / 720)));
    const double rest =
        derivative.high * (angle.low + sine_less_b) + f.high * cosine_less_one + (f.low + derivative.low * b);
    return {f.high, derivative.high * b + rest};
}

/// sin, or cos if `is_turned`
double rounded_sine(const Pair& angle, bool is_turned) {
    const Pair sine = quarter_sine(angle, is_turned);
    return sine.high + sine.low;
}

/// The sine after `quarters` quarter turns: it changes its sign every two of them.
double with_sign(double sine, int quarters) {
    const auto half_turns = static_cast<std::uint64_t>(quarters) >> 1U;
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(sine) ^ half_turns << 63U);
}

}  // namespace

double sin(double angle) {
    if (!std::isfinite(angle)) { return kNotANumber; }
    if (std::abs(angle) < kIsItsSine) { return angle; }
    const Remainder left = remainder_of(angle);
    return with_sign(rounded_sine(left.angle, left.quarters % 2 != 0), left.quarters);
}

double cos(double angle) {
    if (!std::isfinite(angle)) { return kNotANumber; }
    const Remainder left = remainder_of(angle);
    return with_sign(rounded_sine(left.angle, left.quarters % 2 == 0), left.quarters + 1);
}

SineAndCosine sine_and_cosine(double angle) {
    if (!std::isfinite(angle)) { return {kNotANumber, kNotANumber}; }
    if (std::abs(angle) < kIsItsSine) { return {angle, 1.0}; }
    const Remainder left = remainder_of(angle);
    const bool is_turned = left.quarters % 2 != 0;
    const double sine = rounded_sine(left.angle, false);
    const double cosine = rounded_sine(left.angle, true);
    return {
        with_sign(is_turned ? cosine : sine, left.quarters),
        with_sign(is_turned ? sine : cosine, left.quarters + 1)};
}

double tan(double angle) {
    if (!std::isfinite(angle)) { return kNotANumber; }
    if (std::abs(angle) < kIsItsSine) { return angle; }
    const Remainder left = remainder_of(angle);
    const bool is_turned = left.quarters % 2 != 0;
    const Pair sine = quarter_sine(left.angle, is_turned);
    const Pair cosine = quarter_sine(left.angle, !is_turned);
    const Pair tangent = sum_of_ordered(sine.high, sine.low) / sum_of_ordered(cosine.high, cosine.low);
    const double value = tangent.high + tangent.low;
    return is_turned ? -value : value;
}

}  // namespace jw::elementary
