#pragma once

#include <array>
#include <cmath>

#include "core/jets/body_kinematics.hpp"
#include "core/jets/drivers.hpp"

/// Power series along a path: everything in a jet as a polynomial of one parameter. They are a coordinate
/// choice (r, p with A = G Lᵀ), and a primitive is expanded by its own line in primitives.hpp.
namespace jw {

/// Coefficients 0 to 8. Watt's linkage leaves its line at the fifth order. A linkage that leaves its line
/// only beyond the eighth order is off by only 1e-7 within a fifth of a radian.
inline constexpr int kOrders = 9;

struct PowerSeries {};

/// Coefficients of a vector, one per column.
template <int Dim>
using Coefficients = Eigen::Matrix<double, Dim, kOrders>;

template <>
struct BodyKinematics<PowerSeries> {
    Coefficients<3> r = Coefficients<3>::Zero();
    Coefficients<4> p = Coefficients<4>::Zero();
};

struct SeriesOfTheta {
    Coefficients<1> value = Coefficients<1>::Zero();
};
template <>
struct ThetaOfChoice<PowerSeries> {
    using Type = SeriesOfTheta;
};

template <Content K, int Dim, unsigned S>
struct Jet<PowerSeries, K, Dim, S> {
    using Vector = Eigen::Matrix<double, Dim, 1>;
    static constexpr int kDim = Dim;

    Vector value = Vector::Zero();                    ///< coefficient 0
    Coefficients<Dim> w = Coefficients<Dim>::Zero();  ///< the others; column 0 is not used
    Coefficients<1> size = Coefficients<1>::Zero();   ///< of each coefficient: sum of the sizes of its terms

    Vector coefficient(int k) const { return k == 0 ? value : Vector(w.col(k)); }
};

namespace detail {

template <class J>
void set_coefficient(J& jet, int k, const typename J::Vector& w) {
    if (k == 0) {
        jet.value = w;
    } else {
        jet.w.col(k) = w;
    }
}

template <class J, int Rows>
void set_coefficients(J& jet, const Eigen::Matrix<double, Rows, kOrders>& w) {
    jet.value = w.col(0);
    jet.w = w;
    jet.size = w.colwise().norm();
}

/// Cauchy product for any product of two vectors.
template <class Out, class A, class B, class F>
void multiply(Out& out, const A& a, const B& b, F&& product) {
    for (int n = 0; n < kOrders; ++n) {
        typename Out::Vector sum = Out::Vector::Zero();
        for (int k = 0; k <= n; ++k) {
            sum += product(a.coefficient(k), b.coefficient(n - k));
            out.size(n) += a.size(k) * b.size(n - k);
        }
        set_coefficient(out, n, sum);
    }
}

/// Symmetric bilinear form of two quaternions p and q that equals A s' for q = p.
inline Vec3 polarised(const Vec4& p, const Vec4& q, const Vec3& s) {
    const Vec3 e = p.tail<3>();
    const Vec3 f = q.tail<3>();
    return (p(0) * q(0) - e.dot(f)) * s + e.dot(s) * f + f.dot(s) * e + (p(0) * f + q(0) * e).cross(s);
}

}  // namespace detail

template <Content K, int Dim, unsigned SA, unsigned SB>
Jet<PowerSeries, K, Dim, SA | SB> operator-(
    const Jet<PowerSeries, K, Dim, SA>& a, const Jet<PowerSeries, K, Dim, SB>& b) {
    return {a.value - b.value, a.w - b.w, a.size + b.size};
}

template <Content K, int Dim, unsigned SA, unsigned SB>
Jet<PowerSeries, K, 1, SA | SB> dot(
    const Jet<PowerSeries, K, Dim, SA>& a, const Jet<PowerSeries, K, Dim, SB>& b) {
    Jet<PowerSeries, K, 1, SA | SB> out;
    detail::multiply(
        out, a, b, [](const auto& x, const auto& y) { return Eigen::Matrix<double, 1, 1>(x.dot(y)); });
    return out;
}

template <Content K, unsigned SA, unsigned SB>
Jet<PowerSeries, K, 3, SA | SB> cross(
    const Jet<PowerSeries, K, 3, SA>& a, const Jet<PowerSeries, K, 3, SB>& b) {
    Jet<PowerSeries, K, 3, SA | SB> out;
    detail::multiply(out, a, b, [](const Vec3& x, const Vec3& y) { return Vec3(x.cross(y)); });
    return out;
}

template <Content K, unsigned S>
Jet<PowerSeries, K, 2, S> stacked(
    const Jet<PowerSeries, K, 1, S>& top, const Jet<PowerSeries, K, 1, S>& bottom) {
    Jet<PowerSeries, K, 2, S> out;
    out.value << top.value, bottom.value;
    out.w << top.w, bottom.w;
    out.size = top.size + bottom.size;
    return out;
}

namespace detail {

/// Cosine and sine of a series, by (cos x)' = -x' sin x and (sin x)' = x' cos x.
template <class J>
struct CosineAndSine {
    J cosine;
    J sine;

    explicit CosineAndSine(const J& x) {
        const auto [s, c] = elementary::sine_and_cosine(x.value(0));
        cosine.value(0) = c;
        sine.value(0) = s;
        cosine.size(0) = sine.size(0) = 1.0;
        for (int n = 1; n < kOrders; ++n) {
            for (int k = 1; k <= n; ++k) {
                const double share = static_cast<double>(k) / n;
                const double factor = share * x.coefficient(k)(0);
                cosine.w(n) -= factor * sine.coefficient(n - k)(0);
                sine.w(n) += factor * cosine.coefficient(n - k)(0);
                cosine.size(n) += share * x.size(k) * sine.size(n - k);
            }
            sine.size(n) = cosine.size(n);
        }
    }
};

}  // namespace detail

template <Content K, unsigned S>
Jet<PowerSeries, K, 1, S> cos(const Jet<PowerSeries, K, 1, S>& x) {
    return detail::CosineAndSine(x).cosine;
}

template <Content K, unsigned S>
Jet<PowerSeries, K, 1, S> sin(const Jet<PowerSeries, K, 1, S>& x) {
    return detail::CosineAndSine(x).sine;
}

template <Content K, unsigned S>
Jet<PowerSeries, K, 1, S> scaled(double factor, const Jet<PowerSeries, K, 1, S>& x) {
    return {factor * x.value, factor * x.w, std::abs(factor) * x.size};
}

template <Content K, unsigned S>
void set_constant(Jet<PowerSeries, K, 1, S>& out, double x) {
    out.value(0) = x;
    out.size(0) = std::abs(x);
}

/// Function of one operand: its Taylor series Σ f_n (x - x_0)^n, by Horner's rule.
template <Content K, unsigned S>
Jet<PowerSeries, K, 1, S> applied(const FormulaStep& step, const Jet<PowerSeries, K, 1, S>& x) {
    using Series = Taylor<double, kOrders>;
    const auto f = formula_steps::result_of(step, Series::variable(x.value(0))).c;
    Jet<PowerSeries, K, 1, S> change = x;
    set_constant(change, 0.0);
    Jet<PowerSeries, K, 1, S> out;
    for (std::size_t n = f.size(); n-- > 0;) {
        out = dot(out, change);
        out.value(0) += f[n];
        out.size(0) += std::abs(f[n]);
    }
    return out;
}

template <Content K, unsigned S>
Jet<PowerSeries, K, 4, S> parameters(const BodyKinematics<PowerSeries>& body) {
    Jet<PowerSeries, K, 4, S> out;
    detail::set_coefficients(out, body.p);
    return out;
}

template <Content K, unsigned S>
Jet<PowerSeries, K, 3, S> arm(const BodyKinematics<PowerSeries>& body, const Vec3& s_local) {
    const auto p = parameters<K, S>(body);
    Jet<PowerSeries, K, 3, S> out;
    detail::multiply(
        out, p, p, [&](const Vec4& x, const Vec4& y) { return detail::polarised(x, y, s_local); });
    out.size *= s_local.norm();
    return out;
}

template <Content K, unsigned S>
Jet<PowerSeries, K, 3, S> point(const BodyKinematics<PowerSeries>& body, const Vec3& s_local) {
    Jet<PowerSeries, K, 3, S> out = arm<K, S>(body, s_local);
    out.value += body.r.col(0);
    out.w += body.r;
    out.size += body.r.colwise().norm();
    return out;
}

template <class C, Content K>
Jet<C, K, 1, kTheta> artificial(const SeriesOfTheta& theta) {
    Jet<C, K, 1, kTheta> out;
    detail::set_coefficients(out, theta.value);
    return out;
}

template <Content K, int Dim, unsigned S>
Jet<PowerSeries, K, 1, S> component(const Jet<PowerSeries, K, Dim, S>& a, int k) {
    Jet<PowerSeries, K, 1, S> out;
    out.value(0) = a.value(k);
    out.w = a.w.row(k);
    out.size = a.size;
    return out;
}

}  // namespace jw
