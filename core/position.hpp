#pragma once

#include <functional>
#include <variant>

#include "core/branches.hpp"
#include "core/newton.hpp"

/// Position analysis: Newton-Raphson, wrong branches left, and a diagnosis where it fails.
namespace jw {

/// Why a position could not be found.
enum class FailureCause {
    cannot_close,    ///< the equations contradict each other: a closest fit was found, and it is not zero
    wrong_branch,    ///< only solutions with anti-parallel axes or half-turned sides were found
    singular,        ///< the iteration ended at a pose where independent equations are lost
    no_convergence,  ///< none of these could be shown
};

struct PositionFailure {
    FailureCause cause = FailureCause::no_convergence;
    int row = 0;                           ///< largest residual at the closest fit
    double value = 0.0;                    ///< Φ of that row there
    double residual = 0.0;                 ///< scaled
    double smallest_singular_value = 0.0;  ///< relative to the largest, at the closest fit
    int iterations = 0;
    std::optional<WrongBranch> branch;
};

struct PositionOutcome {
    NewtonOutcome newton;
    int branches_left = 0;  ///< how often a wrong branch was left on the way
    std::optional<PositionFailure> failure;

    bool ok() const { return !failure.has_value(); }
};

/// What happens on the way, for a lesson to show.
using PositionEvent = std::variant<NewtonStep, WrongBranch>;
using PositionObserver = std::function<void(const PositionEvent&, const State&)>;

/// Brings `state` onto the constraints at time `t`. On failure `state` is left as it was.
/// @param observer called after every iteration (with the state after its step) and at every branch left
template <class C>
PositionOutcome solve_position(
    const System& system, State& state, double t, const PositionObserver& observer = {});

}  // namespace jw
