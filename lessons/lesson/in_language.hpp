#pragma once

#include <concepts>
#include <string_view>
#include <type_traits>
#include <variant>

#include "lessons/lesson/exercise.hpp"
#include "lessons/lesson/lesson.hpp"

/// Lessons and exercises in another language than the one that they are written in.
namespace jw {

/// Calls `visit` with every text for people of a lesson.
template <class AnyLesson, class Visit>
requires std::same_as<std::remove_const_t<AnyLesson>, Lesson>
void for_each_text(AnyLesson& lesson, Visit&& visit) {
    for (auto* text : {&lesson.title, &lesson.text, &lesson.summary}) { visit(*text); }
    auto& steps = lesson.step_texts;
    visit(steps.bodies);
    for (auto& text : steps.joints) { visit(text); }
    for (auto& text : steps.drivers) { visit(text); }
    visit(steps.motion);
    for (auto& at : steps.times) { visit(at.text); }
    for (auto& claim : lesson.claims) { visit(claim.why); }
    for (auto& question : lesson.questions) {
        visit(question.ask);
        visit(question.why);
        auto* const choice = std::get_if<ChoiceAnswer>(&question.answer);
        if (choice == nullptr) { continue; }
        for (auto& text : choice->choices) { visit(text); }
    }
    for (auto& trial : lesson.trials) { visit(trial.text); }
}

/// Calls `visit` with every text for people of an exercise and of its alternatives.
template <class AnyExercise, class Visit>
requires std::same_as<std::remove_const_t<AnyExercise>, Exercise>
void for_each_text(AnyExercise& exercise, Visit&& visit) {
    for (auto* text : {&exercise.title, &exercise.ask, &exercise.why}) { visit(*text); }
    for (auto& hint : exercise.hints) { visit(hint); }
    for (auto& item : exercise.items) { visit(item); }
    for (auto& choice : exercise.choices) {
        visit(choice.text);
        visit(choice.why);
    }
    for (auto& alternative : exercise.alternatives) { for_each_text(alternative, visit); }
}

/// The lesson with its texts in the language `tag` (Text::show); a text that is not translated stays as it
/// is. Writing it to a file gives the same lesson, with all of its languages.
inline Lesson in_language(Lesson lesson, std::string_view tag) {
    for_each_text(lesson, [&](Text& text) { text.show(tag); });
    return lesson;
}

}  // namespace jw
