#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/session/story/story.hpp"
#include "core/kinematics/freedoms.hpp"

/// Free motions of a pose as lists show them: in words, with the verdict on each.
namespace jw {

/// Judgements, one per free motion; nothing for bodies that no equation constrains. Empty: not judged.
using FreedomJudgements = std::vector<std::optional<FreedomJudgement>>;

/// Judgements on the free motions of a pose. @return empty if there are so many that a reader would have to
/// wait
FreedomJudgements judgements_on(
    const System& system, const State& state, double t, const std::vector<FreeMotion>& motions);

/// A free motion in a list.
struct ListedMotion {
    std::string text;  ///< "crank: ω′z 1; rocker: ω′z 0.258"
    std::string told;  ///< "finite · crank: ω′z 1; rocker: ω′z 0.258"; the same as `text` if not judged
    std::optional<FreedomJudgement> judgement;
    int index = -1;  ///< in the list of free motions; -1 for bodies that no equation constrains
};

/// Entries of the list: one per free motion, but a single one for bodies that no equation constrains.
std::vector<ListedMotion> listed_motions(
    const System& system, const std::vector<FreeMotion>& motions, const FreedomJudgements& judgements);

/// List of free motions that is judged when it is first read.
using MotionsWhenAsked = WhenAsked<std::vector<ListedMotion>>;

}  // namespace jw
