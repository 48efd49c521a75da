#pragma once

#include <string>
#include <vector>

#include "app/session/story/story.hpp"

namespace jw::snapshot {

/// Number of moments of the motion in snapshots, if nothing else is said.
inline constexpr int kMoments = 3;

/// A step of a story of which a snapshot is taken.
struct Shot {
    std::string name;  ///< of its files: "bodies", "A-equations", "A", "motion-0.5"
    int step = 0;
};

/// Treatment of chosen names that no step has: an error when recording, a difference later.
enum class UnknownShots { refused, left_out };

/// Selects the steps of a lesson that are taken.
struct ShotChoice {
    int moments = kMoments;         ///< of the motion; 0: none, even if the author tells something there
    std::vector<std::string> only;  ///< names of the only shots taken; empty: as `shots_of` says

    bool operator==(const ShotChoice&) const = default;
};

/// Without a choice by name: every step at which a reader stops. These are the bodies, the equations of each
/// joint and driver, the mechanism when they hold, answers, failures, and `moments` of the motion at equal
/// distances, including its beginning and end, and those at which a timed text of the author begins to be
/// shown. The step after iterations and questions tells about them; they and every other moment can be chosen
/// by name.
///
/// A name says what is shown, not which step it is, so that it stays the same when a joint is added
/// elsewhere. It has only letters, digits, '-', '_' and '.'; other bytes become %C3.
/// @throws std::runtime_error for a name that no step has, with a similar name, if such names are refused
std::vector<Shot> shots_of(const Story& story, const ShotChoice& choice, UnknownShots unknown);

}  // namespace jw::snapshot
