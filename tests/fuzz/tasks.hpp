#pragma once

#include <vector>

#include "app/exercises/kinds.hpp"

namespace jw::fuzz {

/// Tasks of one student: one or two exercises of every kind, made once.
const std::vector<Task>& tasks();

/// Judges, and promises for every judgement: a share of 0 to 1, which is 1 exactly if the answer is right and
/// 0 if it was not understood, and a sentence if it is not right.
Judged judged(const Task& task, const Handed& handed);

}  // namespace jw::fuzz
