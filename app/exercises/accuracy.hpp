#pragma once

#include <string>

#include "app/exercises/task.hpp"

namespace jw {

/// How exact an answer in numbers has to be, as a sentence that does not tell the answer: "Four significant
/// digits in each number are enough.", "It may be off by 0.01 m."; empty if it must be exact or is no number.
std::string accuracy_text(const Task& task);

}  // namespace jw
