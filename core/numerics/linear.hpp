#pragma once

#include <cstddef>

#include <Eigen/Geometry>

#include "core/eigen/kernels.hpp"

/// Small fixed-size algebra in the notation of the book: tilde and bar operators.
namespace jw {

using Vec3 = Eigen::Vector3d;
using Vec4 = Eigen::Vector4d;
using Mat3 = Eigen::Matrix3d;
using Mat4 = Eigen::Matrix4d;
using Mat34 = Eigen::Matrix<double, 3, 4>;
using VectorX = Eigen::VectorXd;
using MatrixX = Eigen::MatrixXd;

/// Index into a standard container from an int or Eigen::Index.
inline std::size_t at(Eigen::Index index) { return static_cast<std::size_t>(index); }

/// ã: the 3x3 skew matrix with ã v = a x v.
/// @source slide 3
inline Mat3 tilde(const Vec3& a) {
    Mat3 m;
    // clang-format off
    m <<    0.0, -a.z(),  a.y(),
          a.z(),    0.0, -a.x(),
         -a.y(),  a.x(),    0.0;
    // clang-format on
    return m;
}

/// The bar operator, 4x4, with Lᵀ s' = bar(s') p (the minus operator of the book).
/// @source slide 21; sign of the skew block in docs/notation.md
inline Mat4 bar(const Vec3& s_local) {
    Mat4 m;
    m(0, 0) = 0.0;
    m.block<1, 3>(0, 1) = -s_local.transpose();
    m.block<3, 1>(1, 0) = s_local;
    m.block<3, 3>(1, 1) = -tilde(s_local);
    return m;
}

/// A unit vector perpendicular to `a`, always the same one for the same direction. The cross product with the
/// axis along which `a` is smallest has a length of at least 0.8 |a| before it is normalised.
inline Vec3 perpendicular_to(const Vec3& a) {
    Eigen::Index least = 0;
    a.cwiseAbs().minCoeff(&least);
    return a.cross(Vec3::Unit(least)).normalized();
}

/// Three or four numbers of an array as a vector.
inline Eigen::Map<Vec3> vec3(double* numbers) { return Eigen::Map<Vec3>(numbers); }
inline Eigen::Map<const Vec3> vec3(const double* numbers) { return Eigen::Map<const Vec3>(numbers); }
inline Eigen::Map<Vec4> vec4(double* numbers) { return Eigen::Map<Vec4>(numbers); }
inline Eigen::Map<const Vec4> vec4(const double* numbers) { return Eigen::Map<const Vec4>(numbers); }

}  // namespace jw
