#pragma once

#include <functional>
#include <vector>

#include "core/motion/motion_equations.hpp"

/// Gragg's modified midpoint rule, extrapolated to a step of length 0: an integrator that no method of the
/// program shares a table, a step control or a sample with. It computes references.
namespace jw {

/// Integrates from times.front() to times.back(); a step ends at each of the times; y is projected after it.
/// @param tolerance of a step, for every number against 1 and its own size
/// @param receive given y at every time
/// @return false where no step is short enough, or `most_steps` are not enough
/// @source Hairer, Nørsett, Wanner: Solving Ordinary Differential Equations I, II.9
bool extrapolate(
    MotionEquations& equations, std::vector<double> y, const std::vector<double>& times, double tolerance,
    long most_steps, const std::function<void(const std::vector<double>& y)>& receive);

}  // namespace jw
