#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/session/story/story.hpp"

/// The story as a timeline: its stretches, its ends, and the places to jump to.
namespace jw {

/// A run of steps that belong together.
struct Stretch {
    int first = 0;
    int last = 0;
    std::string name;  ///< of the joint or driver; "bodies", "motion"
    Step::Kind kind = Step::Kind::bodies;
};

/// The story cut into its additions and the motion.
std::vector<Stretch> stretches_of(const Story& story);

/// Index of the last step.
int last_step(const Story& story);

/// Index of the first moment of the motion; nothing if nothing moves.
std::optional<int> first_moment(const Story& story);

/// First step of the next stretch after `step` (`direction` 1), or of the one before it (-1); at the ends the
/// last step and the first.
int next_joint(const Story& story, int step, int direction);

/// Finds the step to begin at: "12" (as the window counts, from 1), the name of a joint or driver, or
/// "t=0.5".
/// @return index of the step, or nothing if `place` is none of these
std::optional<int> step_at(const Story& story, const std::string& place);

/// Place in a story, so that the same place is found in the story of a changed lesson.
struct StoryPlace {
    Step::Kind kind = Step::Kind::bodies;
    std::optional<Addition> subject;
    int nth = 0;  ///< of the steps about the same subject
    int question = -1;
    double t = 0.0;
};

StoryPlace place_of(const Story& story, int index);

/// The step of another story that is nearest to a place: the same kind of step of the same joint, or the
/// last step if the joint is gone or not reached.
int find_place(const Story& story, const StoryPlace& place);

/// The moment of the motion nearest to time `t`; the last step if there is no motion.
int nearest_moment(const Story& story, double t);

}  // namespace jw
