#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "core/model/mechanism.hpp"

/// Flat state of the equations of motion: an array of r, p, ṙ, ω' for every moving body.
namespace jw {

inline constexpr int kNumbersPerBody = 13;
inline constexpr int kPositionsPerBody = 7;

/// Numbers of the n-th moving body.
inline double* body_numbers(double* y, std::size_t n) {
    return y + static_cast<std::ptrdiff_t>(n) * kNumbersPerBody;
}
inline const double* body_numbers(const double* y, std::size_t n) {
    return y + static_cast<std::ptrdiff_t>(n) * kNumbersPerBody;
}

/// Indices of the bodies that move, ascending.
std::vector<int> moving_bodies_of(const Mechanism& mechanism);
/// Flat state of the start pose and velocities as given.
std::vector<double> flat_start(const Mechanism& mechanism);

/// Writes a state and a motion to y; `moving` lists the moving bodies.
void pack(const State& state, const Motion& motion, std::span<const int> moving, double* y);
/// Reads state and motion from y; bodies that do not move are left unchanged.
void unpack(const double* y, std::span<const int> moving, State& state, Motion& motion);

/// State and motion of all bodies at y, artificial coordinates included.
std::pair<State, Motion> unpacked(const Mechanism& mechanism, std::span<const int> moving, const double* y);

/// Kind and weight of a number of y, for error norms.
struct NumberScale {
    enum class Kind { way, turn, velocity, omega };
    Kind kind = Kind::way;
    double weight = 1.0;  ///< displacement or velocity that the number causes, as a multiple of its size
};

/// Scales of bodies with r, p, ṙ and three numbers of rotation, ω or ω', or four, ṗ.
std::vector<NumberScale> flat_scales(int size, int numbers_per_body);

/// Writes r and p of all bodies, then their rates, then half their second derivatives.
void flat_derivatives(const double* y, const double* y_dot, int bodies, double* out);
/// Writes y from values and rates of r and p; p need not be unit.
void flat_state_of(const double* value, const double* rate, int bodies, double* y);

/// Moves y by six numbers per body: translation [m] and rotation [rad, body frame]; velocities are unchanged.
void displace(double* y, const double* six, std::size_t bodies);

}  // namespace jw
