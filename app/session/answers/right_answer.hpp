#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/session/answers/question_view.hpp"
#include "app/session/story/story.hpp"

/// The right answers to the questions of a lesson, found in its story, and verdicts on given answers.
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

struct GivenAnswer {
    bool understood = false;
    bool right = false;
    std::string note;  ///< "You said 3.", or why the answer was not understood
};

/// @param given  the number of a choice, from 1, or the beginning of its text; a number with or without unit:
///   "30", "30 deg", "1/3"; the name of a thing; the seven coordinates of a pose (pose_text)
GivenAnswer judge_answer(
    const QuestionView& view, const RightAnswer& right, const Mechanism& mechanism, const std::string& given);

/// "x y z e0 e1 e2 e3" with all digits.
std::string pose_text(const BodyPose& pose);

}  // namespace jw
