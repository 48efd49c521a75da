#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/motion/loads.hpp"
#include "core/statics/modes.hpp"

/// Statics: poses at which a mechanism stays at rest under its loads.
namespace jw {

/// Kind of equilibrium that is looked for.
enum class Seek {
    where_it_rests,  ///< the one to which the forces push the mechanism from the start; not unstable
    nearest,         ///< the one to which Newton's method leads from the start, stable or not
};

/// Result of a search.
struct RestOutcome {
    enum class Failure {
        none,
        endless,         ///< the forces push on, and do not change
        too_many_steps,  ///< the equilibrium is far away, or only short steps are proved
        no_step,         ///< the forces push, but no step along them is proved to stay on the branch
        no_value,        ///< a law has no value at the pose, or so near that rounding hides it
        no_descent,      ///< `nearest`: no step decreases the forces
    };
    Failure failure = Failure::none;
    std::string law;         ///< source of the law without a value
    State state;             ///< of the centroidal frames; the last one that was reached
    Loads loads;             ///< with the turns of rotational springs counted up to `state`
    std::vector<int> turns;  ///< whole turns of the angle of each joint on the way
    Motion acceleration;     ///< of the bodies from rest at `state`: 0 at an equilibrium
    int freedoms = 0;
    int steps = 0;
    /// Largest force or torque that is left over on a body, divided by the sizes of loads and reactions on
    /// it.
    double residual = 0.0;
    SmallMotions motions;  ///< about the equilibrium, if one was found
};

/// Finds an equilibrium: a pose with δᵀ Q = 0 for every δ with Φq δ = 0. Drivers and loads are those of time
/// `t` and stand still.
///
/// `where_it_rests` follows the forces like a motion so heavily damped that it has no velocity: each step
/// solves (|K| + μ I) δ = Q along the freedoms, orthonormal in M, with μ such that no body turns by more than
/// a fifth of a radian. |K| is K where it is positive definite; elsewhere the eigenvalues of its symmetric
/// part have their absolute values, so that the step leads along the forces. Near a stable equilibrium μ is
/// 0, and this is Newton's method. `nearest` reduces |Q| along the freedoms, in the metric of M⁻¹, by damped
/// least squares. Every step is corrected by Newton's method on Φ; in loops it is taken only if it is proved
/// that it stays on its branch.
/// @param start of the centroidal frames, satisfies the constraints at time `t` [s]
/// @source slide 24 with q̇ = q̈ = 0
RestOutcome find_equilibrium(const Centroidal& scene, const State& start, double t, Seek seek);

/// The same search step by step, for callers that do other work in between.
class EquilibriumSearch {
public:
    /// Arguments as of find_equilibrium; `scene` must outlive the search.
    EquilibriumSearch(const Centroidal& scene, const State& start, double t, Seek seek);
    ~EquilibriumSearch();

    /// Takes the next step. @return false if the search has ended
    bool go_on();
    /// Result of a search that has ended. Call it once: it computes the small motions.
    RestOutcome outcome();

private:
    class Search;
    std::unique_ptr<Search> search_;
};

}  // namespace jw
