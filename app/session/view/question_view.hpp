#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/session/story/story.hpp"

/// Questions of a lesson, their answers, and what somebody answered.
namespace jw {

struct QuestionView {
    std::string ask;                   ///< with formulas between dollar signs, like the next three
    std::vector<std::string> choices;  ///< empty where a number is asked for
    std::string answer;                ///< empty until it is answered
    std::string why;
    std::string unit;       ///< of a number, may be empty
    bool answered = false;  ///< this is the answer, not the question
};

/// @param step a question or an answer of the story
QuestionView question_view_of(const Story& story, const Step& step);

/// What is right, found in the story.
struct RightAnswer {
    int choice = -1;         ///< index among the choices; -1: it is a number
    double number = 0.0;     ///< in the unit that is asked for
    double tolerance = 0.0;  ///< likewise; 0 of counts
    double turn = 0.0;       ///< answers that differ by this are the same; 0: none are
    bool known = false;      ///< false: the story does not get there
};
/// @param step the answer, or a step at which it is known
RightAnswer right_answer(const Story& story, const Question& question, const Step& step);

/// What somebody answered: the number of a choice from 1 (or its beginning), or a number with or without its
/// unit, such as "30", "30 deg", "1/3".
struct GivenAnswer {
    bool understood = false;
    bool right = false;
    std::string note;  ///< "You said 3.", or why it was not understood
};
GivenAnswer judge_answer(const QuestionView& view, const RightAnswer& right, const std::string& given);

}  // namespace jw
