#pragma once

#include <functional>
#include <variant>

#include "core/poses/diagnosis.hpp"
#include "core/poses/newton.hpp"

/// Position analysis: Newton-Raphson, correction of wrong branches, and a diagnosis if it fails.
namespace jw {

/// Result of position analysis.
struct PositionOutcome {
    NewtonOutcome newton;
    int branches_left = 0;  ///< number of wrong branches that were left
    std::optional<PositionFailure> failure;

    bool ok() const { return !failure.has_value(); }
};

/// Event during the solve, for a lesson to show.
using PositionEvent = std::variant<NewtonStep, WrongBranch>;
using PositionObserver = std::function<void(const PositionEvent&, const State&)>;

/// Moves `state` onto the constraints at time `t` [s]. On failure `state` is unchanged.
/// @param observer called after every iteration (with the state after its step) and at every branch left
template <class C>
PositionOutcome solve_position(
    const System& system, State& state, double t, const PositionObserver& observer = {});

}  // namespace jw
