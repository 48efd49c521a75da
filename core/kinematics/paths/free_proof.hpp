#pragma once

#include <memory>

#include "core/equations/system.hpp"
#include "core/kinematics/proof/step_proof.hpp"

/// Proof that a step of a free motion stays on its branch.
namespace jw {

/// The mechanism with its drivers fixed at their values at `t`.
Mechanism at_rest(Mechanism mechanism, double t);

/// Proves steps of free motions, whose drivers stand still: time is the length of the path. Freedoms that
/// remain follow the cubic path. Only joints of loops are considered, because a body with a single joint has
/// only one branch.
class FreeProof {
public:
    /// @return nothing if there is nothing to prove, or if loops have more than kMostProvedColumns
    static std::unique_ptr<FreeProof> of(const System& system, double t);

    FreeProof(Mechanism still, const Selection& loops, const System& rows);

    /// True if the step is proved; if it is not, a shorter one may be.
    /// @param velocity a free motion per unit of `length`
    bool holds(
        const State& from, const Motion& velocity, const State& to, const Motion& velocity_there,
        double length);
    /// False if rounding hides the branch: no step from this pose can be proved, however short.
    bool decides_at(const State& state, const Motion& velocity);

    /// Most steps to prove in one movement of the hand; the cost of a step grows with the cube of the number
    /// of bodies.
    int most_steps() const;

private:
    Mechanism still_;
    System system_;
    StepProof proof_;
    double length_ = 0.0;  ///< of all steps that were proved
};

}  // namespace jw
