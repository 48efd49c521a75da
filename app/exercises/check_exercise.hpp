#pragma once

#include <string>
#include <vector>

#include "app/exercises/task.hpp"
#include "app/session/claims/checks.hpp"

/// Proves that an exercise is sound, by solving it.
namespace jw {

struct ExerciseCheck {
    std::string name;
    int variants = 0;                   ///< variants that were tried
    int draws = 0;                      ///< draws that were needed for them
    int mistakes = 0;                   ///< known mistakes, each named by its feedback
    std::vector<std::string> problems;  ///< what is wrong, empty if nothing is
    // how similar the variants are
    int least_nonzero = 0;  ///< entries of the answer that are not zero
    int most_nonzero = 0;
    double least_condition = 1.0;
    double most_condition = 1.0;

    bool holds() const { return problems.empty(); }
};

/// Draws variants and hands in the right answer (which has to be right), the answer of every known mistake
/// (which has to be named) and nonsense (which has to be refused or wrong).
ExerciseCheck check_exercise(const Exercise& exercise, int variants);

/// Results of `jointwise check` for several exercises, one for each; as check_exercise.
std::vector<ClaimResult> check_exercises(const std::vector<Exercise>& exercises, int variants);

}  // namespace jw
