#pragma once

#include <string>
#include <vector>

#include "app/session/story/story.hpp"

/// Questions of a lesson, as they are put and answered.
namespace jw {

struct QuestionView {
    enum class Kind {
        number,
        choice,
        thing,  ///< clicked, or named
        pose,   ///< of a body, led there by hand, or typed
    };
    Kind kind = Kind::number;
    std::string ask;                   ///< with formulas between dollar signs, like the next three
    std::vector<std::string> choices;  ///< of a choice only
    std::string answer;                ///< empty until it is answered
    std::string why;
    std::string how;                 ///< to answer: what is clicked or typed; empty for numbers and choices
    std::string unit;                ///< of a number, may be empty
    std::vector<std::string> names;  ///< of all things that can be clicked; of a thing only
    Thing::Kind thing = Thing::Kind::row;  ///< of a thing only
    std::vector<Thing> right;  ///< of a thing only: any of them is right; empty until it is answered
    bool answered = false;     ///< this is the answer, not the question
};

/// The joint that a question comes before and asks for a row or vector of, -1 if there is none: its equations
/// and vectors are shown although it is not added yet.
int joint_asked_about(const Lesson& lesson, const Step& step);

/// @param step a question or an answer of the story
QuestionView question_view_of(const Story& story, const Step& step);

}  // namespace jw
