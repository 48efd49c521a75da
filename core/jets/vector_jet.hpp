#pragma once

#include <cmath>
#include <type_traits>

#include "core/elementary/elementary.hpp"
#include "core/jets/coordinates.hpp"

/// Jets: vectors that carry their derivatives. Every primitive of the book is a difference, a dot product or
/// a cross product of two such vectors, so the product rule below is the only place where derivatives of
/// constraints are written down.
///
/// A jet has a value and, depending on `Content`:
///  - the Jacobian: blocks on body i, body j and on an artificial coordinate θ;
///  - the motion: `rate` (time derivative) and `bias` (the part of the second time derivative that is
///    quadratic in the velocities), so that γ of an equation is -bias.
///
/// An example by hand, n1 of two axes s = A s' in (r, ω'). An arm has the rate ṡ = ω̃ s, the block -A s̃' on
/// ω', and, without accelerations, the bias ω̃ ṡ. `dot` gives
///     Φ    = s_iᵀ s_j
///     Φ̇    = ṡ_iᵀ s_j + s_iᵀ ṡ_j
///     Φω'  = -s_jᵀ A_i s̃'_i  on body i,  -s_iᵀ A_j s̃'_j  on body j
///     bias = (ω̃_i ṡ_i)ᵀ s_j + 2 ṡ_iᵀ ṡ_j + s_iᵀ (ω̃_j ṡ_j)
/// and with aᵀ ω̃ = -(ω̃ a)ᵀ its γ = -bias is that of the book's table (p. 299):
///     γ = -2 ṡ_iᵀ ṡ_j + ṡ_iᵀ ω̃_i s_j + ṡ_jᵀ ω̃_j s_i
namespace jw {

/// Derivatives that a jet carries.
enum class Content { jacobian, motion };

/// Coordinates that a jet depends on; known at compile time, so that absent blocks cost nothing.
enum Sides : unsigned { kNone = 0, kBodyI = 1, kBodyJ = 2, kTheta = 4 };

namespace detail {

template <int Tag>
struct Absent {};

/// T if `Present`, else an empty type; `Tag` makes several empty members distinct, so that none needs an
/// address.
template <bool Present, class T, int Tag>
using Optional = std::conditional_t<Present, T, Absent<Tag>>;

}  // namespace detail

template <class C, Content K, int Dim, unsigned S>
struct Jet {
    using Vector = Eigen::Matrix<double, Dim, 1>;
    using BodyBlock = Eigen::Matrix<double, Dim, kColumnsPerBody<C>>;
    static constexpr int kDim = Dim;
    static constexpr unsigned kSides = S;
    static constexpr bool kMotion = K == Content::motion;

    Vector value;
    [[no_unique_address]] detail::Optional<kMotion, Vector, 0> rate;
    [[no_unique_address]] detail::Optional<kMotion, Vector, 1> bias;
    [[no_unique_address]] detail::Optional<!kMotion && (S & kBodyI) != 0, BodyBlock, 2> block_i;
    [[no_unique_address]] detail::Optional<!kMotion && (S & kBodyJ) != 0, BodyBlock, 3> block_j;
    [[no_unique_address]] detail::Optional<!kMotion && (S & kTheta) != 0, Vector, 4> block_theta;
};

namespace detail {

/// Operand without blocks.
struct Blockless {
    static constexpr unsigned kSides = kNone;
};

/// Adds up the blocks of the operands that have one; `a` and `b` are maps Block -> Block.
template <class Out, class A, class B, class MapA, class MapB>
void combine_blocks(Out& out, const A& a, const B& b, MapA&& map_a, MapB&& map_b) {
    const auto combine = [&](auto side, auto member) {
        constexpr bool in_a = (A::kSides & decltype(side)::value) != 0;
        constexpr bool in_b = (B::kSides & decltype(side)::value) != 0;
        if constexpr (in_a && in_b) {
            out.*member(out) = map_a(a.*member(a)) + map_b(b.*member(b));
        } else if constexpr (in_a) {
            out.*member(out) = map_a(a.*member(a));
        } else if constexpr (in_b) {
            out.*member(out) = map_b(b.*member(b));
        }
    };
    combine(std::integral_constant<unsigned, kBodyI>{}, [](const auto& x) {
        return &std::decay_t<decltype(x)>::block_i;
    });
    combine(std::integral_constant<unsigned, kBodyJ>{}, [](const auto& x) {
        return &std::decay_t<decltype(x)>::block_j;
    });
    combine(std::integral_constant<unsigned, kTheta>{}, [](const auto& x) {
        return &std::decay_t<decltype(x)>::block_theta;
    });
}

}  // namespace detail

template <class C, Content K, int Dim, unsigned SA, unsigned SB>
Jet<C, K, Dim, SA | SB> operator-(const Jet<C, K, Dim, SA>& a, const Jet<C, K, Dim, SB>& b) {
    Jet<C, K, Dim, SA | SB> out;
    out.value = a.value - b.value;
    if constexpr (K == Content::motion) {
        out.rate = a.rate - b.rate;
        out.bias = a.bias - b.bias;
    } else {
        detail::combine_blocks(
            out, a, b, [](const auto& block) { return block; },
            [](const auto& block) { return (-block).eval(); });
    }
    return out;
}

/// Dot product aᵀ b; for two scalar jets their product.
template <class C, Content K, int Dim, unsigned SA, unsigned SB>
Jet<C, K, 1, SA | SB> dot(const Jet<C, K, Dim, SA>& a, const Jet<C, K, Dim, SB>& b) {
    Jet<C, K, 1, SA | SB> out;
    out.value(0) = a.value.dot(b.value);
    if constexpr (K == Content::motion) {
        out.rate(0) = a.rate.dot(b.value) + a.value.dot(b.rate);
        out.bias(0) = a.bias.dot(b.value) + 2.0 * a.rate.dot(b.rate) + a.value.dot(b.bias);
    } else {
        detail::combine_blocks(
            out, a, b, [&](const auto& block) { return (b.value.transpose() * block).eval(); },
            [&](const auto& block) { return (a.value.transpose() * block).eval(); });
    }
    return out;
}

/// Cross product a x b.
template <class C, Content K, unsigned SA, unsigned SB>
Jet<C, K, 3, SA | SB> cross(const Jet<C, K, 3, SA>& a, const Jet<C, K, 3, SB>& b) {
    Jet<C, K, 3, SA | SB> out;
    out.value = a.value.cross(b.value);
    if constexpr (K == Content::motion) {
        out.rate = a.rate.cross(b.value) + a.value.cross(b.rate);
        out.bias = a.bias.cross(b.value) + 2.0 * a.rate.cross(b.rate) + a.value.cross(b.bias);
    } else {
        const Mat3 a_tilde = tilde(a.value);
        const Mat3 b_tilde = tilde(b.value);
        detail::combine_blocks(
            out, a, b, [&](const auto& block) { return (-b_tilde * block).eval(); },
            [&](const auto& block) { return (a_tilde * block).eval(); });
    }
    return out;
}

/// Chain rule: f(x) of a scalar jet, given f, f' and f'' at x.
template <class C, Content K, unsigned S>
Jet<C, K, 1, S> chain(const Jet<C, K, 1, S>& x, double f, double f_prime, double f_second) {
    Jet<C, K, 1, S> out;
    out.value(0) = f;
    if constexpr (K == Content::motion) {
        out.rate(0) = f_prime * x.rate(0);
        out.bias(0) = f_prime * x.bias(0) + f_second * x.rate(0) * x.rate(0);
    } else {
        const auto scaled = [&](const auto& block) { return (f_prime * block).eval(); };
        detail::combine_blocks(out, x, detail::Blockless{}, scaled, scaled);
    }
    return out;
}

template <class C, Content K, unsigned S>
Jet<C, K, 1, S> cos(const Jet<C, K, 1, S>& x) {
    const auto [sine, cosine] = elementary::sine_and_cosine(x.value(0));
    return chain(x, cosine, -sine, -cosine);
}

template <class C, Content K, unsigned S>
Jet<C, K, 1, S> sin(const Jet<C, K, 1, S>& x) {
    const auto [sine, cosine] = elementary::sine_and_cosine(x.value(0));
    return chain(x, sine, cosine, -sine);
}

template <class C, Content K, unsigned S>
Jet<C, K, 1, S> scaled(double factor, const Jet<C, K, 1, S>& x) {
    return chain(x, factor * x.value(0), factor, 0.0);
}

/// Angle of the plane vector (x, y) in (-π, π] [rad]. No derivative at x = y = 0.
template <class C, Content K, unsigned SY, unsigned SX>
Jet<C, K, 1, SX | SY> atan2(const Jet<C, K, 1, SY>& y, const Jet<C, K, 1, SX>& x) {
    Jet<C, K, 1, SX | SY> out;
    const double x0 = x.value(0);
    const double y0 = y.value(0);
    const double square = x0 * x0 + y0 * y0;
    out.value(0) = elementary::atan2(y0, x0);
    if constexpr (K == Content::motion) {
        // d/dt of (x ẏ - y ẋ) / ρ²
        out.rate(0) = (x0 * y.rate(0) - y0 * x.rate(0)) / square;
        const double half_square_rate = x0 * x.rate(0) + y0 * y.rate(0);
        out.bias(0) = (x0 * y.bias(0) - y0 * x.bias(0) - 2.0 * half_square_rate * out.rate(0)) / square;
    } else {
        detail::combine_blocks(
            out, y, x, [&](const auto& block) { return (x0 / square * block).eval(); },
            [&](const auto& block) { return (-y0 / square * block).eval(); });
    }
    return out;
}

// Sources of jets: an arm fixed in a body, a point of a body, an Euler parameter, an artificial coordinate.

namespace detail {

template <class C, Content K, int Dim, unsigned S>
auto& own_block(Jet<C, K, Dim, S>& jet) {
    static_assert(S == kBodyI || S == kBodyJ);
    if constexpr (S == kBodyI) {
        return jet.block_i;
    } else {
        return jet.block_j;
    }
}

}  // namespace detail

/// Arm s = A s', a vector fixed in body i (S = kBodyI) or j.
template <Content K, unsigned S, class C>
Jet<C, K, 3, S> arm(const BodyKinematics<C>& body, const Vec3& s_local) {
    Jet<C, K, 3, S> out;
    out.value = body.A * s_local;
    if constexpr (requires { body.alpha; }) {
        out.rate = body.omega.cross(out.value);
        out.bias = body.omega.cross(out.rate) + body.alpha.cross(out.value);
    } else if constexpr (K == Content::motion) {
        out.rate = body.A_dot * s_local;
        out.bias = body.A_bias * s_local;
    } else {
        auto& block = detail::own_block(out);
        block.template leftCols<3>().setZero();
        block.template rightCols<C::kAngular>() = C::arm_block(body, s_local, out.value);
    }
    return out;
}

/// Point r + A s' of body i (S = kBodyI) or j [m].
template <Content K, unsigned S, class C>
Jet<C, K, 3, S> point(const BodyKinematics<C>& body, const Vec3& s_local) {
    Jet<C, K, 3, S> out = arm<K, S>(body, s_local);
    out.value += body.r;
    if constexpr (K == Content::motion) {
        out.rate += body.r_dot;
        if constexpr (requires { body.r_ddot; }) { out.bias += body.r_ddot; }
    } else {
        detail::own_block(out).template leftCols<3>().setIdentity();
    }
    return out;
}

/// d from a point of body i to a point of body j [m].
template <Content K, class C>
auto vector_between(
    const BodyKinematics<C>& i, const Vec3& B_i_local, const BodyKinematics<C>& j, const Vec3& B_j_local) {
    return point<K, kBodyJ>(j, B_j_local) - point<K, kBodyI>(i, B_i_local);
}

/// Euler parameters p of body i (S = kBodyI) or j.
template <Content K, unsigned S, class C>
Jet<C, K, 4, S> parameters(const BodyKinematics<C>& body) {
    Jet<C, K, 4, S> out;
    out.value = body.p;
    if constexpr (K == Content::motion) {
        out.rate = body.p_dot;
        out.bias = body.p_bias;
    } else {
        auto& block = detail::own_block(out);
        block.template leftCols<3>().setZero();
        for (int k = 0; k < 4; ++k) {
            block.template block<1, C::kAngular>(k, 3) = C::parameter_block(body.p, k);
        }
    }
    return out;
}

/// One component of a vector.
template <class C, Content K, int Dim, unsigned S>
Jet<C, K, 1, S> component(const Jet<C, K, Dim, S>& a, int k) {
    Jet<C, K, 1, S> out;
    out.value(0) = a.value(k);
    if constexpr (K == Content::motion) {
        out.rate(0) = a.rate(k);
        out.bias(0) = a.bias(k);
    } else {
        const auto row = [&](const auto& block) { return block.row(k).eval(); };
        detail::combine_blocks(out, a, detail::Blockless{}, row, row);
    }
    return out;
}

/// Artificial coordinate θ, with a column of its own.
template <class C, Content K>
Jet<C, K, 1, kTheta> artificial(const Theta& theta) {
    Jet<C, K, 1, kTheta> out;
    out.value(0) = theta.value;
    if constexpr (K == Content::motion) {
        out.rate(0) = theta.rate;
        out.bias(0) = 0.0;
    } else {
        out.block_theta(0) = 1.0;
    }
    return out;
}

}  // namespace jw
