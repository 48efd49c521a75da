#include "core/elementary/remainder.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace jw::elementary {

namespace {

/// The first 1216 bits of 2/π: enough for angles up to 2^1024.
constexpr std::array<std::uint32_t, 38> kTwoOverPi{
    0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0, 0xdb629599, 0x3c439041, 0xfe5163ab, 0xdebbc561,
    0xb7246e3a, 0x424dd2e0, 0x06492eea, 0x09d1921c, 0xfe1deb1c, 0xb129a73e, 0xe88235f5, 0x2ebb4484,
    0xe99c7026, 0xb45f7e41, 0x3991d639, 0x835339f4, 0x9c845f8b, 0xbdf9283b, 0x1ff897ff, 0xde05980f,
    0xef2f118b, 0x5a0a6d1f, 0x6d367ecf, 0x27cb09b7, 0x4f463f66, 0x9e5fea2d, 0x7527bac7, 0xebe5f17b,
    0x3d0739f7, 0x8a5292ea, 0x6bfb5fb1, 0x1f8d5d08, 0x56033046, 0xfc7b6bab};

/// 224 bits, the most significant first.
using Words = std::array<std::uint32_t, 7>;

/// Bits of 2/π from bit `first` on; bit 0 is the first one after the point, and all bits before it are 0.
Words bits_from(int first) {
    const auto word = [](int k) -> std::uint64_t {
        return k < 0 || k >= static_cast<int>(kTwoOverPi.size()) ? 0
                                                                 : kTwoOverPi[static_cast<std::size_t>(k)];
    };
    const int index = (first + 128) / 32 - 4;  // rounded down for negative ones, too
    const int shift = first - 32 * index;
    Words words{};
    for (int k = 0; k < static_cast<int>(words.size()); ++k) {
        const std::uint64_t two = word(index + k) << 32U | word(index + k + 1);
        words[static_cast<std::size_t>(k)] = static_cast<std::uint32_t>(two >> (32 - shift));
    }
    return words;
}

/// factor times `words`, modulo 2^224
Words times(std::uint64_t factor, const Words& words) {
    const std::array<std::uint64_t, 2> digits{factor & 0xffffffffU, factor >> 32U};
    Words result{};
    for (std::size_t d = 0; d < digits.size(); ++d) {
        std::uint64_t carry = 0;
        for (std::size_t k = words.size(); k-- > d;) {
            const std::uint64_t at = digits[d] * words[k] + result[k - d] + carry;
            result[k - d] = static_cast<std::uint32_t>(at);
            carry = at >> 32U;
        }
    }
    return result;
}

void negate(Words& words) {
    std::uint64_t carry = 1;
    for (std::size_t k = words.size(); k-- > 0;) {
        carry += static_cast<std::uint32_t>(~words[k]);
        words[k] = static_cast<std::uint32_t>(carry);
        carry >>= 32U;
    }
}

/// The words as a fraction of 2^224.
Pair fraction_of(const Words& words) {
    std::size_t first = 0;
    while (first + 4 < words.size() && words[first] == 0) { ++first; }
    // words of 32 bits are exact, and so are the sums of the rest
    Pair value;
    double weight = std::ldexp(1.0, -32 * static_cast<int>(first + 1));
    for (std::size_t k = first; k < words.size(); ++k, weight *= 0x1p-32) {
        value = value + Pair{weight * words[k], 0.0};
    }
    return value;
}

}  // namespace

// By Payne and Hanek: the leading bits of 2/π, whose product with the angle's last bit is a multiple of four
// quarter turns, are left out. The product with the next 224 bits is truncated at 2^-169 quarter turns, and
// no double is nearer than 2^-62 to a quarter turn.
Remainder exact_remainder(double angle) {
    const auto bits = std::bit_cast<std::uint64_t>(std::abs(angle));
    const int exponent = static_cast<int>(bits >> 52U) - 1075;
    const std::uint64_t digits = (bits & ((std::uint64_t{1} << 52U) - 1)) | std::uint64_t{1} << 52U;
    Words turn = times(digits, bits_from(exponent - 2));

    // four quarter turns are 2^224
    int quarters = static_cast<int>(turn[0] >> 30U);
    const bool is_beyond_half = (turn[0] >> 29U & 1U) != 0;
    turn[0] &= 0x3fffffffU;
    if (is_beyond_half) {
        ++quarters;
        turn[0] |= 0xc0000000U;
        negate(turn);
    }
    const Pair left = fraction_of(turn) * Pair{4.0 * kHalfPi.high, 4.0 * kHalfPi.low};
    const bool is_negative = angle < 0.0;
    return {is_beyond_half != is_negative ? -left : left, (is_negative ? -quarters : quarters) & 3};
}

}  // namespace jw::elementary
