#pragma once

#include <string>
#include <vector>

#include "app/exercises/kinds.hpp"

/// Feedback on an answer.
namespace jw {

struct AnswerVerdict {
    Judged judged;
    MatrixX given;  ///< as it was understood, in the unit that is asked for; empty if it is not a number
    std::vector<std::vector<bool>> wrong;  ///< entries that differ; empty if right or a single number
};

/// Judges an answer of any kind except a program.
AnswerVerdict verdict_on(const Task& task, const Handed& handed);
/// The verdict on an answer that was judged already.
AnswerVerdict verdict_of(const Task& task, const Handed& handed, Judged judged);

/// The right answer for people, with formulas between dollar signs; code has its own lines.
std::string solution_words(const Task& task);

}  // namespace jw
