#pragma once

#include <array>
#include <cstdlib>

/// Functions that the marked copies of the sources call where they can be made wrong; see marks.hpp.
namespace jw::mutation {

/// Number of the one mutant that is active in this run, from the environment; 0: none.
inline int active() {
    static const int number = [] {
        const char* text = std::getenv("JW_MUTANT");
        return text == nullptr ? 0 : std::atoi(text);
    }();
    return number;
}

/// Sign of the term that follows.
inline double sign(int mutant) { return active() == mutant ? -1.0 : 1.0; }

inline double number(int mutant, double value) { return active() == mutant ? 1.25 * value : value; }

/// Condition of a loop that the mutant does not enter.
inline bool never(int mutant, bool condition) { return active() != mutant && condition; }

/// Condition of a branch, negated by the mutant.
inline bool otherwise(int mutant, bool condition) { return (active() == mutant) != condition; }

/// Four mutants: each changes the sign of one derivative of a jet, and not its value.
template <class J>
J jet(int first, J out) {
    if constexpr (requires { out.away; }) {
        // bounds are mutated in majorants.hpp itself
    } else if constexpr (J::kMotion) {
        out.rate *= sign(first + 2);
        out.bias *= sign(first + 3);
    } else {
        const auto flip_block = [&](unsigned side, int mutant) {
            if constexpr ((J::kSides & 1U) != 0) { out.block_i *= side == 1U ? sign(mutant) : 1.0; }
            if constexpr ((J::kSides & 2U) != 0) { out.block_j *= side == 2U ? sign(mutant) : 1.0; }
            if constexpr ((J::kSides & 4U) != 0) { out.block_theta *= side == 4U ? sign(mutant) : 1.0; }
        };
        constexpr unsigned sides = J::kSides;
        constexpr unsigned lowest = sides & (~sides + 1U);
        constexpr unsigned highest = (sides & 4U) != 0 ? 4U : (sides & 2U) != 0 ? 2U : 1U;
        flip_block(lowest, first);
        flip_block(highest, first + 1);
    }
    return out;
}

}  // namespace jw::mutation

namespace jw {

/// A sign before a jet applies to all of it.
template <class J>
requires requires { J::kMotion; }
J operator*(double factor, J out) {
    out.value *= factor;
    if constexpr (J::kMotion) {
        out.rate *= factor;
        out.bias *= factor;
    } else {
        if constexpr ((J::kSides & 1U) != 0) { out.block_i *= factor; }
        if constexpr ((J::kSides & 2U) != 0) { out.block_j *= factor; }
        if constexpr ((J::kSides & 4U) != 0) { out.block_theta *= factor; }
    }
    return out;
}

/// Bounds hold for both signs.
template <class J>
requires requires(J jet) { jet.away; }
J operator*(double factor, J out) {
    out.value *= factor;
    return out;
}

/// Sign before bounds of derivatives.
template <std::size_t N>
std::array<double, N> operator*(double factor, std::array<double, N> bounds) {
    for (double& bound : bounds) { bound *= factor; }
    return bounds;
}
template <class B>
requires requires(B b) { b.second[0][0] + b.first[0]; }
B operator*(double factor, B bounds) {
    bounds.first = factor * bounds.first;
    for (auto& row : bounds.second) { row = factor * row; }
    return bounds;
}

/// Sign before an inertia.
template <class I>
requires requires { I::M, I::H, I::J; }
[[gnu::always_inline]] inline I operator*(double factor, const I& inertia) {
    return {factor * inertia.M, factor * inertia.H, factor * inertia.J};
}

}  // namespace jw
