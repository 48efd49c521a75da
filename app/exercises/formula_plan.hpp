#pragma once

#include <string>
#include <vector>

#include "app/exercises/mistakes.hpp"
#include "app/session/wording/messages.hpp"
#include "lessons/exercise/exercise.hpp"

/// The formula of an exercise, read, with all that mistakes make of it: the same for all variants.
namespace jw {

/// A mistake at one place of the formula.
struct PlannedMistake {
    const FormulaMistake* mistake = nullptr;
    Message says;                  ///< feedback with the thing that was changed
    std::string shown;             ///< the altered formula, or definition, in LaTeX
    math::Row expression;          ///< what is evaluated
    std::vector<math::Row> where;  ///< definitions before it
};

struct FormulaPlan {
    math::Row asked;               ///< the first side
    math::Row found;               ///< the last one
    std::vector<math::Row> where;  ///< definitions
    std::vector<math::Row> given;  ///< symbols whose values are told
    std::vector<PlannedMistake> mistakes;
};

/// @param exercise  with a formula that can be read
FormulaPlan formula_plan(const Exercise& exercise);

/// Whether the mistakes of that name are among those that the exercise names, or it names none.
bool looks_for(const Exercise& exercise, const std::string& mistake);

/// Plan of the same formula whose mistakes are pairs: two terms that are missing or have the wrong sign, as
/// far as the exercise looks for each of the two. An altered formula that several pairs lead to is there
/// once.
FormulaPlan plan_of_two_terms(const FormulaPlan& plan, const Exercise& exercise);

}  // namespace jw
