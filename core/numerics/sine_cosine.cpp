#include "core/numerics/sine_cosine.hpp"

#include <array>
#include <cmath>

#include "core/elementary/elementary.hpp"
#include "core/elementary/remainder.hpp"
#include "core/numerics/triples.hpp"

namespace jw {

namespace {

using elementary::kFar;
using elementary::kQuarter;
using elementary::kQuarterLast;
using elementary::kQuarterNext;
using elementary::kQuartersPerRadian;
using elementary::kRounds;

/// (sin r - r) / r³ and (cos r - 1 + r²/2) / r⁴ in powers of r², minimax on |r| <= π/4.
/// @source fdlibm, k_sin.c and k_cos.c
const std::array kSine{-1.66666666666666324348e-01, 8.33333333332248946124e-03,  -1.98412698298579493134e-04,
                       2.75573137070700676789e-06,  -2.50507602534068634195e-08, 1.58969099521155010221e-10};
const std::array kCosine{4.16666666666666019037e-02, -1.38888888888741095749e-03,
                         2.48015872894767294178e-05, -2.75573143513906633035e-07,
                         2.08757232129817482790e-09, -1.13596475577881948265e-11};

/// Sine and cosine of as many angles as a register holds: first those of the remainder modulo a quarter turn,
/// then the right one of the two with the right sign.
template <Lanes V>
JW_INLINE void find(const double* angle, double* cosine, double* sine) {
    using Register = typename V::Register;
    using Bits = typename V::Bits;
    const Register x = *reinterpret_cast<const Register*>(angle);
    const Register rounded = x * kQuartersPerRadian + kRounds;
    const Register quarters = rounded - kRounds;
    const Bits count = reinterpret_cast<const Bits&>(rounded);
    // r, and its rounding error
    const Register without_first = x - quarters * kQuarter;
    const Register next = quarters * kQuarterNext;
    const Register without_next = without_first - next;
    const Register last = quarters * kQuarterLast;
    const Register r = without_next - last;
    const Register rest = ((without_first - without_next) - next) + ((without_next - r) - last);
    const Register z = r * r;

    Register by_cube = z * kSine[5] + kSine[4];
    for (std::size_t k = 4; k-- > 0;) { by_cube = z * by_cube + kSine[k]; }
    const Register sine_of_r = r + (z * r * by_cube + rest);
    Register by_fourth = z * kCosine[5] + kCosine[4];
    for (std::size_t k = 4; k-- > 0;) { by_fourth = z * by_fourth + kCosine[k]; }
    const Register half = 0.5 * z;
    const Register most = 1.0 - half;
    const Register cosine_of_r = most + (((1.0 - most) - half) + (z * z * by_fourth - r * rest));

    const Bits is_odd = -(count & 1);
    const Bits s_bits = reinterpret_cast<const Bits&>(sine_of_r);
    const Bits c_bits = reinterpret_cast<const Bits&>(cosine_of_r);
    *reinterpret_cast<Bits*>(sine) = ((s_bits & ~is_odd) | (c_bits & is_odd)) ^ (count >> 1 << 63);
    *reinterpret_cast<Bits*>(cosine) = ((c_bits & ~is_odd) | (s_bits & is_odd)) ^ ((count + 1) >> 1 << 63);
}

/// True if quarter turns in three parts are not enough; true for NaN.
bool is_far(double angle) { return !(std::abs(angle) < kFar); }

}  // namespace

void find_sines_and_cosines(std::span<FourTurns> turns, Registers registers) {
    in_registers(registers, [&]<Lanes V>(std::type_identity<V>) JW_PASS {
        constexpr int lanes = sizeof(typename V::Register) / sizeof(double);
        for (FourTurns& four : turns) {
            for (int k = 0; k < 4; k += lanes) { find<V>(&four.angle[k], &four.cosine[k], &four.sine[k]); }
        }
    });
    for (FourTurns& four : turns) {
        for (int k = 0; k < 4; ++k) {
            if (!is_far(four.angle[k])) { continue; }
            const auto [sine, cosine] = elementary::sine_and_cosine(four.angle[k]);
            four.cosine[k] = cosine;
            four.sine[k] = sine;
        }
    }
}

}  // namespace jw
