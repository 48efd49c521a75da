#pragma once

#include <string>
#include <vector>

#include "app/exercises/formulas/mistakes.hpp"
#include "app/session/wording/messages.hpp"
#include "lessons/lesson/exercise.hpp"

/// The parsed formula of an exercise with all its mistaken forms, which are the same for all variants.
namespace jw {

/// A mistake at one place of the formula.
struct PlannedMistake {
    const FormulaMistake* mistake = nullptr;
    Message says;                  ///< feedback with the part that was changed
    std::string shown;             ///< the altered formula, or definition, in LaTeX
    math::Row expression;          ///< what is evaluated
    std::vector<math::Row> where;  ///< definitions before it
};

struct FormulaPlan {
    math::Row asked;               ///< the first side
    math::Row found;               ///< the last side
    std::vector<math::Row> where;  ///< definitions
    std::vector<math::Row> given;  ///< symbols whose values are given
    std::vector<PlannedMistake> mistakes;
};

/// @param exercise  with a formula that can be read
FormulaPlan formula_plan(const Exercise& exercise);

/// True if the exercise names this mistake, or names none.
bool looks_for(const Exercise& exercise, const std::string& mistake);

/// Plan of the same formula with pairs of mistakes: two terms that are missing or have the wrong sign, if the
/// exercise looks for both. If several pairs lead to the same altered formula, it appears once.
FormulaPlan plan_of_two_terms(const FormulaPlan& plan, const Exercise& exercise);

}  // namespace jw
