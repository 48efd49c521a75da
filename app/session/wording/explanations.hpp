#pragma once

#include <string>
#include <vector>

#include "core/kinematics/freedoms.hpp"
#include "core/poses/position.hpp"
#include "core/poses/rank.hpp"

/// Outcomes of the numerics in words: failures, wrong branches, redundant rows, free motions.
namespace jw {

/// Message about a failure: which joint and row, when, how far off, the likely cause, and what to do.
std::string failure_text(const System& system, const PositionFailure& failure);

/// "the axes sᵢ and sⱼ of joint D point in opposite directions (cosine -1)"
std::string branch_text(const System& system, const WrongBranch& wrong);

/// "D · p1 · x = −A · p1 · x + 0.5 B · s · y", with at most `most_terms` terms.
std::string combination_text(const System& system, const RedundantRow& redundant, std::size_t most_terms = 6);

/// "rod: ω′x 1 (it turns on its own)", or the bodies and columns that take part.
std::string free_motion_text(const System& system, const FreeMotion& motion);

/// "violates D by 0.625 y⁵ (order 5); y is that of rod": in SI, for a free motion of first order.
std::string departure_text(const System& system, const Departure& departure);

/// "finite", "to first order only" or "cannot tell".
const char* verdict_text(FreedomVerdict verdict);

/// How a free motion leaves the equations, and whether a nearby motion is finite; empty if it does not leave
/// them.
std::string leaving_text(const System& system, const FreedomJudgement& judgement);

/// Reason why the rank is not known; empty if it is.
std::string undecided_text(const RankReport& report);

/// Sentences about the parts of a rank report that are not proved: the rank, combinations with a residual,
/// motions that are not free. Empty if all parts are proved.
std::vector<std::string> doubts_of(const System& system, const RankReport& report);

}  // namespace jw
