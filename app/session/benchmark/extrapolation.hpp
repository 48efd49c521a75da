#pragma once

#include <functional>
#include <vector>

#include "core/motion/motion_equations.hpp"

/// Gragg's modified midpoint rule, extrapolated to a step of length 0. This integrator computes references:
/// it shares no coefficients, step control or sampling with the program's methods.
namespace jw {

/// Integrates from times.front() to times.back(). A step ends at each of the times; y is projected after each
/// step.
/// @param tolerance of a step: the error of a number y is divided by 1 + |y|
/// @param receive given y at every time
/// @return false if no step is short enough, or `most_steps` are not enough
/// @source Hairer, Nørsett, Wanner: Solving Ordinary Differential Equations I, II.9
bool extrapolate(
    MotionEquations& equations, std::vector<double> y, const std::vector<double>& times, double tolerance,
    long most_steps, const std::function<void(const std::vector<double>& y)>& receive);

}  // namespace jw
