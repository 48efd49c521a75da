#pragma once

#include <string>

#include "app/session/answers/question_view.hpp"
#include "app/session/answers/right_answer.hpp"

/// Judges answers to the questions of a lesson.
namespace jw {

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
