#pragma once

#if __has_include(<sys/platform/x86.h>)
// this header of glibc is written in C: in C++, clang has no _Bool
#if defined(__clang__)
#define _Bool bool
#endif
#include <sys/platform/x86.h>
#if defined(__clang__)
#undef _Bool
#endif
#endif

#include <type_traits>

#include "core/numerics/linear.hpp"

/// Vectors of three numbers, and matrices of three columns, in SIMD registers: four lanes of which the last
/// is zero. The passes over a tree of bodies compute with them; all other code uses Eigen's.
///
/// There are two kinds of registers; Wide needs AVX2. Both do the same operations in the same order, without
/// fused multiply-add, so results are bit-identical on every machine.
namespace jw {

/// Always inlined, for any size: the caller determines the registers that a function computes in.
#define JW_INLINE [[gnu::always_inline]] inline
#define JW_PASS __attribute__((always_inline))  // for lambdas

/// Vector in one wide register; usable only within run_wide.
struct Wide {
    using Register = double __attribute__((vector_size(32), may_alias));
    using Bits = long long __attribute__((vector_size(32), may_alias));
    Register xyz0;

    JW_INLINE static Wide load(const double* four) { return {*reinterpret_cast<const Register*>(four)}; }
    JW_INLINE void store(double* four) const { *reinterpret_cast<Register*>(four) = xyz0; }
    JW_INLINE static Wide of_three(const double* n) { return {Register{n[0], n[1], n[2], 0.0}}; }
    JW_INLINE double operator[](int k) const { return xyz0[k]; }
};
JW_INLINE Wide operator+(const Wide& a, const Wide& b) { return {a.xyz0 + b.xyz0}; }
JW_INLINE Wide operator-(const Wide& a, const Wide& b) { return {a.xyz0 - b.xyz0}; }
JW_INLINE Wide operator*(const Wide& a, const Wide& b) { return {a.xyz0 * b.xyz0}; }
JW_INLINE Wide operator*(double factor, const Wide& a) { return {factor * a.xyz0}; }
/// (y, z, x)
JW_INLINE Wide next(const Wide& a) { return {__builtin_shufflevector(a.xyz0, a.xyz0, 1, 2, 0, 3)}; }

/// Vector in two registers of the base instruction set.
struct Narrow {
    using Register = double __attribute__((vector_size(16), may_alias));
    using Bits = long long __attribute__((vector_size(16), may_alias));
    Register xy;
    Register z0;

    JW_INLINE static Narrow load(const double* four) {
        return {*reinterpret_cast<const Register*>(four), *reinterpret_cast<const Register*>(four + 2)};
    }
    JW_INLINE void store(double* four) const {
        *reinterpret_cast<Register*>(four) = xy;
        *reinterpret_cast<Register*>(four + 2) = z0;
    }
    JW_INLINE static Narrow of_three(const double* n) { return {Register{n[0], n[1]}, Register{n[2], 0.0}}; }
    JW_INLINE double operator[](int k) const { return k < 2 ? xy[k] : z0[0]; }
};
JW_INLINE Narrow operator+(const Narrow& a, const Narrow& b) { return {a.xy + b.xy, a.z0 + b.z0}; }
JW_INLINE Narrow operator-(const Narrow& a, const Narrow& b) { return {a.xy - b.xy, a.z0 - b.z0}; }
JW_INLINE Narrow operator*(const Narrow& a, const Narrow& b) { return {a.xy * b.xy, a.z0 * b.z0}; }
JW_INLINE Narrow operator*(double factor, const Narrow& a) { return {factor * a.xy, factor * a.z0}; }
JW_INLINE Narrow next(const Narrow& a) {
    return {__builtin_shufflevector(a.xy, a.z0, 1, 2), __builtin_shufflevector(a.xy, a.z0, 0, 3)};
}

template <class V>
concept Lanes = std::is_same_v<V, Wide> || std::is_same_v<V, Narrow>;

/// Matrix of three columns.
template <Lanes V>
struct Columns {
    V x;
    V y;
    V z;
};

template <Lanes V>
JW_INLINE V cross(const V& a, const V& b) {
    return next(a * next(b) - next(a) * b);
}
template <Lanes V>
JW_INLINE double dot(const V& a, const V& b) {
    const V products = a * b;
    return (products[0] + products[2]) + products[1];
}
/// d times the identity
template <Lanes V>
JW_INLINE Columns<V> diagonal(double d) {
    constexpr double numbers[] = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
    return {d * V::of_three(numbers), d * V::of_three(numbers + 3), d * V::of_three(numbers + 6)};
}
template <Lanes V>
JW_INLINE Columns<V> operator+(const Columns<V>& m, const Columns<V>& n) {
    return {m.x + n.x, m.y + n.y, m.z + n.z};
}
template <Lanes V>
JW_INLINE Columns<V> operator-(const Columns<V>& m, const Columns<V>& n) {
    return {m.x - n.x, m.y - n.y, m.z - n.z};
}
template <Lanes V>
JW_INLINE Columns<V> operator*(double factor, const Columns<V>& m) {
    return {factor * m.x, factor * m.y, factor * m.z};
}
template <Lanes V>
JW_INLINE V operator*(const Columns<V>& m, const V& v) {
    return v[0] * m.x + v[1] * m.y + v[2] * m.z;
}
template <Lanes V>
JW_INLINE Columns<V> operator*(const Columns<V>& m, const Columns<V>& n) {
    return {m * n.x, m * n.y, m * n.z};
}
/// mᵀ v
template <Lanes V>
JW_INLINE V transposed_times(const Columns<V>& m, const V& v) {
    const Columns<V> unit = diagonal<V>(1.0);
    return dot(m.x, v) * unit.x + dot(m.y, v) * unit.y + dot(m.z, v) * unit.z;
}
JW_INLINE Columns<Wide> transposed(const Columns<Wide>& m) {
    const Wide::Register first = __builtin_shufflevector(m.x.xyz0, m.y.xyz0, 0, 4, 2, 6);
    const Wide::Register second = __builtin_shufflevector(m.x.xyz0, m.y.xyz0, 1, 5, 3, 7);
    const Wide::Register last = __builtin_shufflevector(m.z.xyz0, m.z.xyz0, 0, 3, 2, 3);
    const Wide::Register last_of_second = __builtin_shufflevector(m.z.xyz0, m.z.xyz0, 1, 3, 3, 3);
    return {
        {__builtin_shufflevector(first, last, 0, 1, 4, 5)},
        {__builtin_shufflevector(second, last_of_second, 0, 1, 4, 5)},
        {__builtin_shufflevector(first, last, 2, 3, 6, 7)}};
}
JW_INLINE Columns<Narrow> transposed(const Columns<Narrow>& m) {
    const Narrow::Register zero{0.0, 0.0};
    return {
        {__builtin_shufflevector(m.x.xy, m.y.xy, 0, 2), __builtin_shufflevector(m.z.xy, zero, 0, 2)},
        {__builtin_shufflevector(m.x.xy, m.y.xy, 1, 3), __builtin_shufflevector(m.z.xy, zero, 1, 2)},
        {__builtin_shufflevector(m.x.z0, m.y.z0, 0, 2), m.z.z0}};
}
/// ã
JW_INLINE Columns<Wide> tilde(const Wide& a) {
    const Wide::Register& v = a.xyz0;
    return {
        {__builtin_shufflevector(v, v, 3, 2, 1, 3) * Wide::Register{0.0, 1.0, -1.0, 0.0}},
        {__builtin_shufflevector(v, v, 2, 3, 0, 3) * Wide::Register{-1.0, 0.0, 1.0, 0.0}},
        {__builtin_shufflevector(v, v, 1, 0, 3, 3) * Wide::Register{1.0, -1.0, 0.0, 0.0}}};
}
JW_INLINE Columns<Narrow> tilde(const Narrow& a) {
    using Register = Narrow::Register;
    const Register y0 = __builtin_shufflevector(a.xy, a.z0, 1, 3);
    const Register x0 = __builtin_shufflevector(a.xy, a.z0, 0, 3);
    const Register zeros = __builtin_shufflevector(a.z0, a.z0, 1, 1);
    return {
        {__builtin_shufflevector(a.z0, a.z0, 1, 0) * Register{0.0, 1.0}, y0 * Register{-1.0, 0.0}},
        {a.z0 * Register{-1.0, 0.0}, x0},
        {__builtin_shufflevector(a.xy, a.xy, 1, 0) * Register{1.0, -1.0}, zeros}};
}
/// m ã
template <Lanes V>
JW_INLINE Columns<V> times_tilde(const Columns<V>& m, const V& a) {
    return {a[2] * m.y - a[1] * m.z, a[0] * m.z - a[2] * m.x, a[1] * m.x - a[0] * m.y};
}
/// ã m
template <Lanes V>
JW_INLINE Columns<V> tilde_times(const V& a, const Columns<V>& m) {
    return {cross(a, m.x), cross(a, m.y), cross(a, m.z)};
}
/// a bᵀ
template <Lanes V>
JW_INLINE Columns<V> dyad(const V& a, const V& b) {
    return {b[0] * a, b[1] * a, b[2] * a};
}
/// Inverse of a symmetric matrix.
template <Lanes V>
JW_INLINE Columns<V> inverse_of_symmetric(const Columns<V>& m) {
    const Columns<V> cofactors{cross(m.y, m.z), cross(m.z, m.x), cross(m.x, m.y)};
    return (1.0 / dot(m.x, cofactors.x)) * cofactors;
}

/// Vector in memory; read and written in either kind of register.
struct alignas(32) Triple {
    double number[4] = {0.0, 0.0, 0.0, 0.0};

    Triple& operator=(const Vec3& v) {
        vec3(number) = v;
        return *this;
    }
    template <Lanes V>
    JW_INLINE Triple& operator=(const V& v) {
        v.store(number);
        return *this;
    }
    template <Lanes V>
    JW_INLINE operator V() const {
        return V::load(number);
    }
};

/// Matrix in memory.
struct Triples {
    Triple x;
    Triple y;
    Triple z;

    Triples& operator=(const Mat3& m) {
        x = m.col(0);
        y = m.col(1);
        z = m.col(2);
        return *this;
    }
    template <Lanes V>
    JW_INLINE Triples& operator=(const Columns<V>& m) {
        x = m.x;
        y = m.y;
        z = m.z;
        return *this;
    }
    template <Lanes V>
    JW_INLINE operator Columns<V>() const {
        return {V(x), V(y), V(z)};
    }
};

inline Eigen::Map<const Vec3> vec3(const Triple& v) { return Eigen::Map<const Vec3>(v.number); }
inline Mat3 mat3(const Triples& m) {
    Mat3 out;
    out << vec3(m.x), vec3(m.y), vec3(m.z);
    return out;
}

/// Registers that a pass computes in; both give the same numbers to the last bit.
enum class Registers { narrow, wide };

/// The widest registers that this processor has. If glibc is told not to use wide ones
/// (GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2), this program does not use them either: tests compare the two.
inline Registers widest_registers() {
#if defined(__x86_64__)
#if __has_include(<sys/platform/x86.h>)
    static const bool has_wide = CPU_FEATURE_ACTIVE(AVX2);
#else
    static const bool has_wide = __builtin_cpu_supports("avx2") > 0;
#endif
    return has_wide ? Registers::wide : Registers::narrow;
#else
    return Registers::narrow;
#endif
}

#if defined(__x86_64__)
template <class Pass>
[[gnu::target("avx2")]] void run_wide(const Pass& pass) {
    pass(std::type_identity<Wide>{});
}
#endif

/// Runs a pass in `registers`, which this processor must have. The pass must be JW_PASS, and every function
/// to which it passes registers must be JW_INLINE.
/// @param pass called with std::type_identity of Wide or Narrow
template <class Pass>
void in_registers(Registers registers, const Pass& pass) {
#if defined(__x86_64__)
    if (registers == Registers::wide) {
        run_wide(pass);
        return;
    }
#else
    static_cast<void>(registers);
#endif
    pass(std::type_identity<Narrow>{});
}

}  // namespace jw
