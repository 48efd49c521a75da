#pragma once

#include <functional>
#include <variant>

#include "core/diagnosis.hpp"
#include "core/newton.hpp"

/// Position analysis: Newton-Raphson, wrong branches left, and a diagnosis where it fails.
namespace jw {

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
