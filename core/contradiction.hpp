#pragma once

#include <optional>
#include <vector>

#include "core/system.hpp"

/// Which joints or drivers ask for what cannot be had together, found by leaving some of them out.
namespace jw {

struct Contradiction {
    /// Joints that share the gap at the closest fit, the last of them the one that cannot be added to the
    /// others; empty where drivers are to blame.
    std::vector<int> joints;
    /// Drivers of which all but any one can be followed; a single one leads where the joints cannot follow.
    std::vector<int> drivers;
    /// Of the last joint: which of its primitives is off most if all other equations hold.
    Role role = Role::same_point;
    /// By how much it is then: an angle [rad] of axes and sides, else a length [m]; of a screw's θ an angle.
    double gap = 0.0;
    /// Of the last driver: what it asks for, and what it finds if all other equations hold [rad, m, -].
    double asked = 0.0;
    double found = 0.0;
};

/// @param start a pose from which the equations could be met but for the contradiction
/// @param fit   the closest fit of all equations of `system`
/// @return nothing if no part of the system could be found that fails by itself
std::optional<Contradiction> find_contradiction(
    const System& system, const State& start, const State& fit, double t);

}  // namespace jw
