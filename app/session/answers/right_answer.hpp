#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/session/story/story.hpp"

/// The right answers to the questions of a lesson, found in its story.
namespace jw {

/// Where a body is.
struct BodyPose {
    Vec3 r = Vec3::Zero();       ///< [m]
    Vec4 p{1.0, 0.0, 0.0, 0.0};  ///< (e0, e1, e2, e3), unit

    /// Angle of the turn from one orientation to the other [rad].
    double turn_from(const BodyPose& other) const;
};

struct RightAnswer {
    int choice = -1;                 ///< index among the choices; -1: it is none
    double number = 0.0;             ///< in the unit that is asked for
    double tolerance = 0.0;          ///< likewise, of a pose in m; 0 of counts
    double turn = 0.0;               ///< answers that differ by this are the same; 0: none are
    std::vector<Thing> things = {};  ///< any of them is right
    std::optional<BodyPose> pose = {};
    double tolerance_rad = 0.0;  ///< of the orientation of a pose
    bool known = false;          ///< false: the story does not get there
};
/// @param step the answer, or a step at which it is known
RightAnswer right_answer(const Story& story, const Question& question, const Step& step);
/// Of question `index`, wherever the story answers it.
RightAnswer right_answer(const Story& story, int index);

/// The row of a system as a thing; none for a normalisation.
std::optional<Thing> thing_of_row(const System& system, int row);

}  // namespace jw
