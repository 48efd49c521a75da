#pragma once

#include <concepts>
#include <type_traits>

#include "lessons/lesson/exercise.hpp"

namespace jw {

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

}  // namespace jw
