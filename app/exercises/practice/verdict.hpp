#pragma once

#include <string>
#include <vector>

#include "app/exercises/kinds.hpp"

/// What is said of an answer.
namespace jw {

struct AnswerVerdict {
    Judged judged;
    MatrixX given;  ///< as it was understood, in the unit that is asked for; empty where it is no number
    std::vector<std::vector<bool>> wrong;  ///< entries of `given` that differ; empty where that says nothing
};

/// Judges an answer of any kind but a program.
AnswerVerdict verdict_on(const Task& task, const Handed& handed);
/// The verdict on an answer that was judged already.
AnswerVerdict verdict_of(const Task& task, const Handed& handed, Judged judged);

/// The right answer for people, with formulas between dollar signs; code in lines of its own.
std::string solution_words(const Task& task);

}  // namespace jw
