#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "core/elementary/elementary.hpp"
#include "core/jets/interval.hpp"

/// Taylor coefficients of functions of one variable, of numbers or of intervals.
namespace jw {

/// Coefficients c[k] = f^(k) / k! of a function, up to order N - 1.
/// @tparam S  double; or Interval, whose coefficients bound those at all points of an interval
template <class S, std::size_t N>
struct Taylor {
    std::array<S, N> c{};

    static Taylor constant(double number) {
        Taylor out;
        out.c[0] = S(number);
        return out;
    }
    /// The variable itself.
    static Taylor variable(const S& value) {
        Taylor out;
        out.c[0] = value;
        if constexpr (N > 1) { out.c[1] = S(1.0); }
        return out;
    }

    friend Taylor operator+(Taylor a, const Taylor& b) {
        for (std::size_t k = 0; k < N; ++k) { a.c[k] = a.c[k] + b.c[k]; }
        return a;
    }
    friend Taylor operator-(Taylor a) {
        for (S& c : a.c) { c = -c; }
        return a;
    }
    friend Taylor operator-(Taylor a, const Taylor& b) {
        for (std::size_t k = 0; k < N; ++k) { a.c[k] = a.c[k] - b.c[k]; }
        return a;
    }
    friend Taylor operator*(const Taylor& a, const Taylor& b) {
        Taylor out;
        for (std::size_t k = 0; k < N; ++k) {
            for (std::size_t j = 0; j <= k; ++j) { out.c[k] = out.c[k] + a.c[j] * b.c[k - j]; }
        }
        return out;
    }
    /// Quotient q, from b q = a.
    friend Taylor operator/(const Taylor& a, const Taylor& b) {
        Taylor out;
        for (std::size_t k = 0; k < N; ++k) {
            S sum = a.c[k];
            for (std::size_t j = 1; j <= k; ++j) { sum = sum - b.c[j] * out.c[k - j]; }
            out.c[k] = sum / b.c[0];
        }
        return out;
    }
};

/// Functions of Taylor coefficients. Each follows from a differential equation that the function satisfies,
/// compared coefficient by coefficient.
namespace taylor {

// functions of numbers, like those of intervals in interval.hpp
inline double exp(double x) { return elementary::exp(x); }
inline double log(double x) { return elementary::log(x); }
inline double sqrt(double x) { return std::sqrt(x); }
inline double pow(double x, double n) { return elementary::pow(x, n); }
inline double sin(double x) { return elementary::sin(x); }
inline double cos(double x) { return elementary::cos(x); }
inline double atan(double x) { return elementary::atan(x); }
inline double asin(double x) { return elementary::asin(x); }
inline double acos(double x) { return elementary::acos(x); }

inline double whole(std::size_t k) { return static_cast<double>(k); }

/// The function with the first coefficient `value` and the derivative a' / q.
template <class S, std::size_t N>
Taylor<S, N> integral(const Taylor<S, N>& a, const Taylor<S, N>& q, const S& value) {
    Taylor<S, N> out;
    out.c[0] = value;
    for (std::size_t k = 1; k < N; ++k) {
        S sum = S(whole(k)) * a.c[k];
        for (std::size_t j = 1; j < k; ++j) { sum = sum - S(whole(j)) * (out.c[j] * q.c[k - j]); }
        out.c[k] = sum / (S(whole(k)) * q.c[0]);
    }
    return out;
}

/// Exponential b, from b' = a' b.
template <class S, std::size_t N>
Taylor<S, N> exponential(const Taylor<S, N>& a) {
    Taylor<S, N> out;
    out.c[0] = exp(a.c[0]);
    for (std::size_t k = 1; k < N; ++k) {
        for (std::size_t j = 1; j <= k; ++j) { out.c[k] = out.c[k] + S(whole(j)) * (a.c[j] * out.c[k - j]); }
        out.c[k] = out.c[k] / S(whole(k));
    }
    return out;
}

/// Sine s and cosine c, from s' = a' c and c' = -a' s.
template <class S, std::size_t N>
std::pair<Taylor<S, N>, Taylor<S, N>> sine_and_cosine(const Taylor<S, N>& a) {
    std::pair<Taylor<S, N>, Taylor<S, N>> out;
    auto& [sine, cosine] = out;
    sine.c[0] = sin(a.c[0]);
    cosine.c[0] = cos(a.c[0]);
    for (std::size_t k = 1; k < N; ++k) {
        for (std::size_t j = 1; j <= k; ++j) {
            const S slope = S(whole(j)) * a.c[j];
            sine.c[k] = sine.c[k] + slope * cosine.c[k - j];
            cosine.c[k] = cosine.c[k] - slope * sine.c[k - j];
        }
        sine.c[k] = sine.c[k] / S(whole(k));
        cosine.c[k] = cosine.c[k] / S(whole(k));
    }
    return out;
}

template <class S, std::size_t N>
Taylor<S, N> logarithm(const Taylor<S, N>& a) {
    return integral(a, a, log(a.c[0]));
}

/// Square root b, from b² = a.
template <class S, std::size_t N>
Taylor<S, N> square_root(const Taylor<S, N>& a) {
    Taylor<S, N> out;
    out.c[0] = sqrt(a.c[0]);
    for (std::size_t k = 1; k < N; ++k) {
        S sum = a.c[k];
        for (std::size_t j = 1; j < k; ++j) { sum = sum - out.c[j] * out.c[k - j]; }
        out.c[k] = sum / (S(2.0) * out.c[0]);
    }
    return out;
}

template <class S, std::size_t N>
Taylor<S, N> arc_tangent(const Taylor<S, N>& a) {
    return integral(a, Taylor<S, N>::constant(1.0) + a * a, atan(a.c[0]));
}
template <class S, std::size_t N>
Taylor<S, N> arc_sine(const Taylor<S, N>& a) {
    return integral(a, square_root(Taylor<S, N>::constant(1.0) - a * a), asin(a.c[0]));
}
template <class S, std::size_t N>
Taylor<S, N> arc_cosine(const Taylor<S, N>& a) {
    return integral(a, -square_root(Taylor<S, N>::constant(1.0) - a * a), acos(a.c[0]));
}

/// Absolute value; its derivatives have no bound where the argument may change its sign.
template <std::size_t N>
Taylor<Interval, N> absolute(const Taylor<Interval, N>& a) {
    if (a.c[0].low > 0.0) { return a; }
    if (a.c[0].high < 0.0) { return -a; }
    Taylor<Interval, N> out;
    out.c.fill(Interval::all());
    if (a.c[0].is_bounded()) { out.c[0] = {0.0, a.c[0].magnitude()}; }
    return out;
}
/// Absolute value; at 0, with the derivative from the right.
template <std::size_t N>
Taylor<double, N> absolute(const Taylor<double, N>& a) {
    return a.c[0] < 0.0 ? -a : a;
}

/// Power b: repeated products, or their reciprocal, for an integer n; otherwise from a b' = n a' b.
template <class S, std::size_t N>
Taylor<S, N> power(const Taylor<S, N>& a, double n) {
    if (n == std::floor(n) && n >= 0.0) {
        Taylor<S, N> out = Taylor<S, N>::constant(1.0);
        Taylor<S, N> square = a;
        for (auto left = static_cast<unsigned>(n); left > 0; left /= 2) {
            if (left % 2 == 1) { out = out * square; }
            if (left > 1) { square = square * square; }
        }
        if constexpr (std::is_same_v<S, Interval>) {
            // the product of intervals does not use that both factors are the same number
            const bool is_even = std::fmod(n, 2.0) == 0.0;
            if (is_even && out.c[0].low < 0.0) { out.c[0].low = 0.0; }
        }
        return out;
    }
    if (n == std::floor(n)) { return Taylor<S, N>::constant(1.0) / power(a, -n); }
    Taylor<S, N> out;
    out.c[0] = pow(a.c[0], n);
    for (std::size_t k = 1; k < N; ++k) {
        for (std::size_t j = 1; j <= k; ++j) {
            out.c[k] = out.c[k] + S(n * whole(j) - whole(k - j)) * (a.c[j] * out.c[k - j]);
        }
        out.c[k] = out.c[k] / (S(whole(k)) * a.c[0]);
    }
    return out;
}

}  // namespace taylor

}  // namespace jw
