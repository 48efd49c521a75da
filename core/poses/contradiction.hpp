#pragma once

#include <optional>
#include <vector>

#include "core/equations/system.hpp"

/// Search for joints or drivers that contradict each other, by leaving some of them out.
namespace jw {

/// Joints or drivers that cannot be satisfied together, and the gap of the last one.
struct Contradiction {
    /// Joints that share the gap at the closest fit; the last of them is the one that cannot be added to the
    /// others. Empty where drivers are the cause.
    std::vector<int> joints;
    /// Drivers that can be followed together if any one of them is left out; a single driver leads to a place
    /// where the joints cannot follow.
    std::vector<int> drivers;
    /// Primitive of the last joint with the largest residual if all other equations hold.
    Role role = Role::same_point;
    /// Gap of this primitive then: an angle [rad] for axes, sides and a screw's θ, else a length [m].
    double gap = 0.0;
    /// Value that the last driver prescribes, and its actual value if all other equations hold [rad, m, -].
    double asked = 0.0;
    double found = 0.0;
};

/// @param start a pose from which the equations could be solved without the contradiction
/// @param fit   the closest fit of all equations of `system`
/// @return nothing if no subsystem was found that fails by itself
std::optional<Contradiction> find_contradiction(
    const System& system, const State& start, const State& fit, double t);

}  // namespace jw
