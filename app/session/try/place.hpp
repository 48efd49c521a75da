#pragma once

#include <optional>

#include "app/session/story/story.hpp"

namespace jw {

/// Place in a story, so that the same place is found in the story of a changed lesson.
struct Place {
    Step::Kind kind = Step::Kind::bodies;
    std::optional<Addition> subject;
    int nth = 0;  ///< of the steps about the same subject
    int question = -1;
    double t = 0.0;
};

Place place_of(const Story& story, int index);

/// The step of another story that is nearest to a place: the same kind of step of the same joint, or the
/// last step if the joint is gone or not reached.
int find_place(const Story& story, const Place& place);

/// The moment of the motion nearest to time `t`; the last step if there is no motion.
int nearest_moment(const Story& story, double t);

}  // namespace jw
