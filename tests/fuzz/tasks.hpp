#pragma once

#include <vector>

#include "app/exercises/kinds.hpp"

namespace jw::fuzz {

/// Tasks of one student: one or two exercises of every kind, made once.
const std::vector<Task>& tasks();

/// Judges and promises what every judgement keeps to: a share of 0 to 1, the whole exactly if it is right,
/// nothing for what was not understood, and a sentence for what is not right.
Judged judged(const Task& task, const Handed& handed);

}  // namespace jw::fuzz
