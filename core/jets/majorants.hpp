#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "core/jets/body_kinematics.hpp"
#include "core/jets/drivers.hpp"

/// Majorants: bounds of everything in a jet, over a region of poses instead of at one pose. They are a
/// coordinate choice (r, p with A = G Lᵀ, so that every equation is a polynomial), and a primitive is bounded
/// by its own line in primitives.hpp.
///
/// A region is all poses with |r - r_0| ≤ reach_r and |p - p_0| ≤ reach_p for each body. Content `jacobian`
/// bounds first and second derivatives there, and `motion` the derivatives along a path within it. All
/// operations are sums and products of numbers that are not negative, so the rounding error is proportional
/// to the result; it is allowed for only once, where bounds are compared.
namespace jw {

struct Majorants {};

/// Blocks of coordinates that an equation between two bodies depends on; kArtificial is the artificial
/// coordinate θ, or the target of a driver.
enum Block : std::size_t { kR_i, kP_i, kR_j, kP_j, kArtificial };
inline constexpr std::size_t kBlocks = 5;

/// Bounds of Taylor coefficients along a path: entry k bounds |w^(k)| / k!; entry 0 is not used.
using TaylorSeries = std::array<double, 5>;

/// Body at the middle of a region, and the bounds of its path in it.
template <>
struct BodyKinematics<Majorants> {
    Vec3 r = Vec3::Zero();
    Vec4 p = Vec4::Unit(0);
    Mat3 A = Mat3::Identity();
    double reach_r = 0.0;    ///< [m]
    double reach_p = 0.0;    ///< 0 for a fixed body
    double size_of_p = 1.0;  ///< bound of |p|
    TaylorSeries r_series{};
    TaylorSeries p_series{};
};

/// θ in the middle of its region, and the bounds of its path.
struct BoundedTheta {
    double value = 0.0;
    double reach = 0.0;
    TaylorSeries series{};
};
template <>
struct ThetaOfChoice<Majorants> {
    using Type = BoundedTheta;
};

/// Bounds of the first and second derivatives by blocks of coordinates.
struct DerivativeBounds {
    std::array<double, kBlocks> first{};
    std::array<std::array<double, kBlocks>, kBlocks> second{};
};

template <Content K, int Dim, unsigned S>
struct Jet<Majorants, K, Dim, S> {
    using Vector = Eigen::Matrix<double, Dim, 1>;

    Vector value;       ///< in the middle of the region
    double away = 0.0;  ///< bound of |w - value| in it
    double size = 0.0;  ///< bound of |w| in it
    std::conditional_t<K == Content::motion, TaylorSeries, DerivativeBounds> bounds{};
};

template <Content K>
using Bounds = std::conditional_t<K == Content::motion, TaylorSeries, DerivativeBounds>;

namespace detail {

inline TaylorSeries sum(const TaylorSeries& a, const TaylorSeries& b) {
    TaylorSeries out;
    for (std::size_t k = 0; k < out.size(); ++k) { out[k] = a[k] + b[k]; }
    return out;
}

inline DerivativeBounds sum(const DerivativeBounds& a, const DerivativeBounds& b) {
    DerivativeBounds out;
    for (std::size_t c = 0; c < kBlocks; ++c) {
        out.first[c] = a.first[c] + b.first[c];
        for (std::size_t d = 0; d < kBlocks; ++d) { out.second[c][d] = a.second[c][d] + b.second[c][d]; }
    }
    return out;
}

/// Bounds of a product by the product rule.
inline TaylorSeries product(double size_a, const TaylorSeries& a, double size_b, const TaylorSeries& b) {
    TaylorSeries out{};
    for (std::size_t k = 1; k < out.size(); ++k) {
        out[k] = size_a * b[k] + a[k] * size_b;
        for (std::size_t l = 1; l < k; ++l) { out[k] += a[l] * b[k - l]; }
    }
    return out;
}

inline DerivativeBounds product(
    double size_a, const DerivativeBounds& a, double size_b, const DerivativeBounds& b) {
    DerivativeBounds out;
    for (std::size_t c = 0; c < kBlocks; ++c) {
        out.first[c] = size_a * b.first[c] + a.first[c] * size_b;
        for (std::size_t d = 0; d < kBlocks; ++d) {
            out.second[c][d] = size_a * b.second[c][d] + a.second[c][d] * size_b + a.first[c] * b.first[d] +
                               a.first[d] * b.first[c];
        }
    }
    return out;
}

/// Bounds of f(x) for a function f whose derivatives are at most 1: its Taylor coefficients are below those
/// of the exponential function.
inline TaylorSeries of_bounded_function(const TaylorSeries& x) {
    TaylorSeries out{1.0};
    for (std::size_t n = 1; n < out.size(); ++n) {
        for (std::size_t k = 1; k <= n; ++k) {
            out[n] += static_cast<double>(k) / static_cast<double>(n) * x[k] * out[n - k];
        }
    }
    return out;
}

/// Bounds of f(x), given bounds of the first and second derivative of f.
inline DerivativeBounds chain(const DerivativeBounds& x, double first, double second) {
    DerivativeBounds out;
    for (std::size_t c = 0; c < kBlocks; ++c) {
        out.first[c] = first * x.first[c];
        for (std::size_t d = 0; d < kBlocks; ++d) {
            out.second[c][d] = first * x.second[c][d] + second * x.first[c] * x.first[d];
        }
    }
    return out;
}

inline DerivativeBounds of_bounded_function(const DerivativeBounds& x) { return chain(x, 1.0, 1.0); }

inline double length_of(double top, double bottom) { return std::sqrt(top * top + bottom * bottom); }

/// Bounds of two rows, one above the other.
template <class B>
B stacked(B top, const B& bottom) {
    const auto join = [](auto& of, const auto& with) {
        for (std::size_t k = 0; k < of.size(); ++k) { of[k] = length_of(of[k], with[k]); }
    };
    if constexpr (std::is_same_v<B, TaylorSeries>) {
        join(top, bottom);
    } else {
        join(top.first, bottom.first);
        for (std::size_t c = 0; c < kBlocks; ++c) { join(top.second[c], bottom.second[c]); }
    }
    return top;
}

/// Sets the size of a jet whose value and deviation are known; `most` is another bound of the size.
template <class J>
void set_size(J& jet, double most) {
    jet.size = std::min(jet.value.norm() + jet.away, most);
}

/// Sets all bounds to infinity: a comparison with an infinite bound proves nothing.
template <class J>
void set_unbounded(J& jet) {
    jet.away = jet.size = HUGE_VAL;
    if constexpr (requires { jet.bounds.second; }) {
        jet.bounds.first.fill(HUGE_VAL);
        for (auto& row : jet.bounds.second) { row.fill(HUGE_VAL); }
    } else {
        jet.bounds.fill(HUGE_VAL);
    }
}

template <Content K, int Dim, unsigned S, class A, class B>
void bound_product(Jet<Majorants, K, Dim, S>& out, const A& a, const B& b) {
    out.away = a.away * b.size + a.value.norm() * b.away;
    set_size(out, a.size * b.size);
    out.bounds = product(a.size, a.bounds, b.size, b.bounds);
}

template <class J>
J of_bounded_function(const J& x, double value) {
    J out;
    out.value(0) = value;
    out.away = x.away;
    set_size(out, 1.0);
    out.bounds = of_bounded_function(x.bounds);
    return out;
}

}  // namespace detail

template <Content K, int Dim, unsigned SA, unsigned SB>
Jet<Majorants, K, Dim, SA | SB> operator-(
    const Jet<Majorants, K, Dim, SA>& a, const Jet<Majorants, K, Dim, SB>& b) {
    Jet<Majorants, K, Dim, SA | SB> out;
    out.value = a.value - b.value;
    out.away = a.away + b.away;
    detail::set_size(out, a.size + b.size);
    out.bounds = detail::sum(a.bounds, b.bounds);
    return out;
}

template <Content K, int Dim, unsigned SA, unsigned SB>
Jet<Majorants, K, 1, SA | SB> dot(const Jet<Majorants, K, Dim, SA>& a, const Jet<Majorants, K, Dim, SB>& b) {
    Jet<Majorants, K, 1, SA | SB> out;
    out.value(0) = a.value.dot(b.value);
    detail::bound_product(out, a, b);
    return out;
}

template <Content K, unsigned SA, unsigned SB>
Jet<Majorants, K, 3, SA | SB> cross(const Jet<Majorants, K, 3, SA>& a, const Jet<Majorants, K, 3, SB>& b) {
    Jet<Majorants, K, 3, SA | SB> out;
    out.value = a.value.cross(b.value);
    detail::bound_product(out, a, b);
    return out;
}

template <Content K, unsigned S>
Jet<Majorants, K, 2, S> stacked(const Jet<Majorants, K, 1, S>& top, const Jet<Majorants, K, 1, S>& bottom) {
    Jet<Majorants, K, 2, S> out;
    out.value << top.value, bottom.value;
    out.away = detail::length_of(top.away, bottom.away);
    detail::set_size(out, detail::length_of(top.size, bottom.size));
    out.bounds = detail::stacked(top.bounds, bottom.bounds);
    return out;
}

template <Content K, unsigned S>
Jet<Majorants, K, 1, S> cos(const Jet<Majorants, K, 1, S>& x) {
    return detail::of_bounded_function(x, elementary::cos(x.value(0)));
}

template <Content K, unsigned S>
Jet<Majorants, K, 1, S> sin(const Jet<Majorants, K, 1, S>& x) {
    return detail::of_bounded_function(x, elementary::sin(x.value(0)));
}

template <Content K, unsigned S>
Jet<Majorants, K, 1, S> scaled(double factor, const Jet<Majorants, K, 1, S>& x) {
    const Bounds<K> none{};
    Jet<Majorants, K, 1, S> out;
    out.value = factor * x.value;
    out.away = std::abs(factor) * x.away;
    out.size = std::abs(factor) * x.size;
    out.bounds = detail::product(std::abs(factor), none, 0.0, x.bounds);
    return out;
}

template <Content K, unsigned S>
void set_constant(Jet<Majorants, K, 1, S>& out, double x) {
    out.value(0) = x;
    detail::set_size(out, HUGE_VAL);
}

/// Function of one operand, by the chain rule and the derivatives between the bounds of the operand. If one
/// of these is not bounded, the result has no bounds.
template <Content K, unsigned S>
Jet<Majorants, K, 1, S> applied(const FormulaStep& step, const Jet<Majorants, K, 1, S>& x) {
    const double middle = x.value(0);
    const Interval range = Interval{middle, middle} + Interval{-x.away, x.away};
    const auto f = formula_steps::result_of(step, Taylor<Interval, 5>::variable(range)).c;
    Jet<Majorants, K, 1, S> out;
    out.value(0) = formula_steps::result_of(step, Taylor<double, 1>::constant(middle)).c[0];
    if (!std::ranges::all_of(f, &Interval::is_bounded)) {
        detail::set_unbounded(out);
        return out;
    }
    out.away = f[1].magnitude() * x.away;
    detail::set_size(out, f[0].magnitude());
    if constexpr (K == Content::motion) {
        // Σ |f_n| w^n, by Horner's rule
        for (std::size_t n = f.size(); --n > 0;) {
            out.bounds = detail::product(f[n].magnitude(), out.bounds, 0.0, x.bounds);
        }
    } else {
        out.bounds = detail::chain(x.bounds, f[1].magnitude(), 2.0 * f[2].magnitude());
    }
    return out;
}

/// The map from p to A s' is quadratic: |A s'| = |p|² |s'|.
template <Content K, unsigned S>
Jet<Majorants, K, 3, S> arm(const BodyKinematics<Majorants>& body, const Vec3& s_local) {
    const double length = s_local.norm();
    Jet<Majorants, K, 3, S> out;
    out.value = body.A * s_local;
    out.away = 2.0 * length * body.size_of_p * body.reach_p;
    detail::set_size(out, body.size_of_p * body.size_of_p * length);
    if constexpr (K == Content::motion) {
        out.bounds = detail::product(body.size_of_p, body.p_series, body.size_of_p, body.p_series);
        for (double& coefficient : out.bounds) { coefficient *= length; }
    } else {
        constexpr Block p = S == kBodyI ? kP_i : kP_j;
        out.bounds.first[p] = 2.0 * length * body.size_of_p;
        out.bounds.second[p][p] = 2.0 * length;
    }
    return out;
}

template <Content K, unsigned S>
Jet<Majorants, K, 3, S> point(const BodyKinematics<Majorants>& body, const Vec3& s_local) {
    Jet<Majorants, K, 3, S> out = arm<K, S>(body, s_local);
    out.value += body.r;
    out.away += body.reach_r;
    detail::set_size(out, out.size + body.r.norm() + body.reach_r);
    if constexpr (K == Content::motion) {
        out.bounds = detail::sum(out.bounds, body.r_series);
    } else {
        out.bounds.first[S == kBodyI ? kR_i : kR_j] = 1.0;
    }
    return out;
}

template <Content K, unsigned S>
Jet<Majorants, K, 4, S> parameters(const BodyKinematics<Majorants>& body) {
    Jet<Majorants, K, 4, S> out;
    out.value = body.p;
    out.away = body.reach_p;
    detail::set_size(out, body.size_of_p);
    if constexpr (K == Content::motion) {
        out.bounds = body.p_series;
    } else {
        out.bounds.first[S == kBodyI ? kP_i : kP_j] = 1.0;
    }
    return out;
}

template <class C, Content K>
Jet<C, K, 1, kTheta> artificial(const BoundedTheta& theta) {
    Jet<C, K, 1, kTheta> out;
    out.value(0) = theta.value;
    out.away = theta.reach;
    detail::set_size(out, HUGE_VAL);
    if constexpr (K == Content::motion) {
        out.bounds = theta.series;
    } else {
        out.bounds.first[kArtificial] = 1.0;
    }
    return out;
}

template <Content K, int Dim, unsigned S>
Jet<Majorants, K, 1, S> component(const Jet<Majorants, K, Dim, S>& a, int k) {
    Jet<Majorants, K, 1, S> out;
    out.value(0) = a.value(k);
    out.away = a.away;
    detail::set_size(out, a.size);
    out.bounds = a.bounds;
    return out;
}

}  // namespace jw
