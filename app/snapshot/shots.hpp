#pragma once

#include <string>
#include <vector>

#include "app/session/story/story.hpp"

namespace jw::snapshot {

/// Moments of the motion of which snapshots are taken if nothing else is said.
inline constexpr int kMoments = 3;

/// A step of a story of which a snapshot is taken.
struct Shot {
    std::string name;  ///< of its files: "bodies", "A-equations", "A", "motion-0.5"
    int step = 0;
};

/// What happens to chosen names that no step has: a slip where they are recorded, a difference later.
enum class UnknownShots { refused, left_out };

/// Which steps of a lesson are taken.
struct ShotChoice {
    int moments = kMoments;         ///< of the motion; 0: none, whatever the author tells there
    std::vector<std::string> only;  ///< names of shots in place of all that; empty: as `shots_of` says

    bool operator==(const ShotChoice&) const = default;
};

/// Without a choice by name: every step at which somebody stops to read. That is the bodies, the equations of
/// each joint and driver and the mechanism when they hold, answers, what failed, and `moments` of the motion
/// at equal distances, its beginning and end among them, and those at which a text of the author for a time
/// begins to be shown. Iterations and questions are told by the step after
/// them; they and every other moment can be chosen by name.
///
/// A name says what is shown and not which step it is, so that it stays the same when a joint is added
/// elsewhere. It has letters, digits, '-', '_' and '.' only; other bytes as %C3.
/// @throws std::runtime_error for a chosen name that no step has, with one that was meant, if that is refused
std::vector<Shot> shots_of(const Story& story, const ShotChoice& choice, UnknownShots unknown);

}  // namespace jw::snapshot
