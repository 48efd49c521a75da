#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/session/story/story.hpp"

/// The right answers to the questions of a lesson, found in its story.
namespace jw {

/// Position and orientation of a body.
struct BodyPose {
    Vec3 r = Vec3::Zero();       ///< [m]
    Vec4 p{1.0, 0.0, 0.0, 0.0};  ///< (e0, e1, e2, e3), unit

    /// Angle of the turn from one orientation to the other [rad].
    double turn_from(const BodyPose& other) const;
};

struct RightAnswer {
    int choice = -1;                 ///< index among the choices; -1: the answer is not a choice
    double number = 0.0;             ///< in the unit that is asked for
    double tolerance = 0.0;          ///< in the same unit; for a pose in m; for counts 0
    double turn = 0.0;               ///< answers that differ by this turn are equal; 0: no such turn
    std::vector<Thing> things = {};  ///< any of them is right
    std::optional<BodyPose> pose = {};
    double tolerance_rad = 0.0;  ///< of the orientation of a pose
    bool known = false;          ///< false: the story does not reach the answer
};
/// @param step the answer, or a step at which it is known
RightAnswer right_answer(const Story& story, const Question& question, const Step& step);
/// The right answer to question `index`, at the step where the story answers it.
RightAnswer right_answer(const Story& story, int index);

/// The row of a system as a thing; nothing for a normalisation row.
std::optional<Thing> thing_of_row(const System& system, int row);

}  // namespace jw
