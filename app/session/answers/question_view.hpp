#pragma once

#include <string>
#include <vector>

#include "app/session/story/story.hpp"

/// Questions of a lesson, as they are asked and answered.
namespace jw {

struct QuestionView {
    enum class Kind {
        number,
        choice,
        thing,  ///< clicked, or named
        pose,   ///< of a body, moved there by hand, or typed
    };
    Kind kind = Kind::number;
    std::string ask;                   ///< with formulas between dollar signs, like the next three
    std::vector<std::string> choices;  ///< of a choice only
    std::string answer;                ///< empty until it is answered
    std::string why;
    std::string how;                 ///< how to answer: what to click or type; empty for numbers and choices
    std::string unit;                ///< of a number, may be empty
    std::vector<std::string> names;  ///< all things that can be clicked; only for a thing
    Thing::Kind thing = Thing::Kind::row;  ///< only for a thing
    std::vector<Thing> right;  ///< only for a thing: any of these is right; empty until it is answered
    bool answered = false;     ///< this is the answer, not the question
};

/// The joint after a question that asks for one of its rows or vectors, -1 if there is none. Its equations
/// and vectors are shown although it is not added yet.
int joint_asked_about(const Lesson& lesson, const Step& step);

/// @param step a question or an answer of the story
QuestionView question_view_of(const Story& story, const Step& step);

}  // namespace jw
