#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/mechanism.hpp"

/// The state of the equations of motion as one row of numbers: r, p, ṙ, ω' for every moving body.
namespace jw {

inline constexpr int kNumbersPerBody = 13;

inline Eigen::Map<Vec3> vec3(double* numbers) { return Eigen::Map<Vec3>(numbers); }
inline Eigen::Map<const Vec3> vec3(const double* numbers) { return Eigen::Map<const Vec3>(numbers); }
inline Eigen::Map<Vec4> vec4(double* numbers) { return Eigen::Map<Vec4>(numbers); }
inline Eigen::Map<const Vec4> vec4(const double* numbers) { return Eigen::Map<const Vec4>(numbers); }

/// Numbers of the n-th moving body.
inline double* body_numbers(double* y, std::size_t n) {
    return y + static_cast<std::ptrdiff_t>(n) * kNumbersPerBody;
}
inline const double* body_numbers(const double* y, std::size_t n) {
    return y + static_cast<std::ptrdiff_t>(n) * kNumbersPerBody;
}

std::vector<int> moving_bodies_of(const Mechanism& mechanism);
/// The state as the mechanism's author gave it.
std::vector<double> flat_start(const Mechanism& mechanism);

/// y of a state and a motion; `moving` lists the moving bodies.
void pack(const State& state, const Motion& motion, std::span<const int> moving, double* y);
/// Back; bodies that do not move stay as they are.
void unpack(const double* y, std::span<const int> moving, State& state, Motion& motion);

/// y moved by six numbers per body: translation [m] and turn [rad, body frame]; velocities stay.
void displace(double* y, const double* six, std::size_t bodies);

}  // namespace jw
