#pragma once

#include <optional>
#include <vector>

#include "core/equations/system.hpp"

/// Wrong branches. Φ = 0 does not specify everything: p1 is also satisfied by anti-parallel vectors, the n1
/// of a weld or a prismatic joint by half a turn, the angle row of a screw or a wheel by θ + π. Such
/// solutions are detected and left here.
namespace jw {

/// Constraint that is satisfied on the wrong branch.
struct WrongBranch {
    enum class Kind { anti_parallel, half_turn, screw_angle };
    Kind kind = Kind::anti_parallel;
    int constraint = 0;    ///< index into System::constraints()
    double measure = 0.0;  ///< cosine that should be positive
};

/// Sides of the vectors of n1(h) at the start pose: +1, -1, or 0 where the start does not determine them. One
/// entry per constraint of the system.
std::vector<int> intended_sides(const System& system);

/// First constraint that is satisfied on the wrong branch at `state`. A joint whose axes are not kept
/// parallel, because equations were removed by hand, has only one branch: a pose that looks wrong there can
/// be reached by moving.
/// @param sides from `intended_sides`
std::optional<WrongBranch> find_wrong_branch(
    const System& system, const State& state, const std::vector<int>& sides);

/// True if the equations left out by the rule of slide 5 hold. If one does not although the others do, the
/// kept pair has lost rank on the way, and rows must be chosen again. Rows left out on purpose are not
/// checked.
bool left_out_rows_hold(const System& system, const State& state);

/// True if a state is not on a wrong branch and the rows left out by the rule hold.
bool is_meant(const System& system, const State& state, const std::vector<int>& sides);

/// Turns a body (or θ) by half a turn about the joint, so that Newton's method starts near the right branch.
void leave_branch(const System& system, const WrongBranch& wrong, State& state);

/// Largest part of a change in columns of (r, ω') and θ: displacements are divided by `length`, rotations and
/// θ are unchanged.
double largest_part(const System& system, const VectorX& columns, double length);

/// Largest movement of a body between two states, in the scene's unit of length and rad.
double movement(const System& system, const State& from, const State& to);

/// True if Newton's correction of a prediction along the tangent is small compared with the whole step: if it
/// is more than a third, prediction and solution are on different curves.
/// @param step, correction movements in the scene's unit of length and rad; without movement the result is
///        true
bool is_on_tangent(double step, double correction);

/// True if the state `reached` by Newton's method from a `prediction` along the tangent at `from` is on the
/// same curve; a state on a wrong branch or with a violated equation is not.
/// @param sides from `intended_sides`
bool same_curve(
    const System& system, const State& from, const State& prediction, const State& reached,
    const std::vector<int>& sides);

}  // namespace jw
