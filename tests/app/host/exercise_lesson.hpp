#pragma once

#include <string>
#include <vector>

/// Lessons with exercises, of those that come with the program.
namespace jw::test {

/// One exercise of each kind, named as the kind.
inline const std::vector<std::string> kKindsOfExercises{"number", "vector", "matrix", "pose",  "choose",
                                                        "order",  "code",   "repair", "build", "experiment"};

/// Text of a lesson with an exercise of each kind.
std::string lesson_with_exercises();

}  // namespace jw::test
