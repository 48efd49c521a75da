#pragma once

#include <optional>
#include <vector>

#include "core/system.hpp"

/// Φ = 0 is not the whole specification: p1 is satisfied by anti-parallel vectors, a weld's or a prismatic
/// joint's n1 by a half turn, a screw's angle row by θ + π. Such solutions are found here and left.
namespace jw {

struct WrongBranch {
    enum class Kind { anti_parallel, half_turn, screw_angle };
    Kind kind = Kind::anti_parallel;
    int constraint = 0;    ///< into System::constraints()
    double measure = 0.0;  ///< cosine that should be positive
};

/// Which way the side vectors of n1(h) look at the start pose: +1, -1, or 0 where the start does not tell.
/// One entry per constraint of the system.
std::vector<int> intended_sides(const System& system);

/// The first constraint that is satisfied on the wrong branch at `state`. A joint whose axes may part because
/// equations are taken out by hand has one branch only: what looks wrong there can be reached by moving.
/// @param sides from `intended_sides`
std::optional<WrongBranch> find_wrong_branch(
    const System& system, const State& state, const std::vector<int>& sides);

/// False if an equation that the rule of slide 5 has left out does not hold although the others do: the kept
/// pair has lost rank on the way here, and rows must be chosen anew. Rows left out on purpose are not asked.
bool left_out_rows_hold(const System& system, const State& state);

/// On no wrong branch, and the rows left out hold.
bool is_meant(const System& system, const State& state, const std::vector<int>& sides);

/// Turns a body (or θ) by half a turn about the joint, so that Newton starts next to the right branch.
void leave_branch(const System& system, const WrongBranch& wrong, State& state);

/// Largest movement of a body between two states, in the scene's unit of length and rad.
double movement(const System& system, const State& from, const State& to);

/// True if Newton's correction of a prediction along the tangent is small beside the whole step: beyond a
/// third of it prediction and solution are on different curves.
/// @param step, correction movements in the scene's unit of length and rad; where nothing moves, anything
/// goes
bool is_on_tangent(double step, double correction);

/// True if Newton, from a `prediction` along the tangent at `from`, has `reached` a state of the same curve:
/// a wrong branch or an equation that does not hold is on none.
/// @param sides from `intended_sides`
bool same_curve(
    const System& system, const State& from, const State& prediction, const State& reached,
    const std::vector<int>& sides);

}  // namespace jw
