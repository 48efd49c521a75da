#pragma once

#include <string_view>

#include "lessons/lesson/lesson.hpp"

/// What the course says about the shipped scenes of dynamics: the question before each, what to try and to
/// break, what to remember.
namespace jw::test {

/// The scene with the summary, questions and trials that its lesson is shipped with.
/// @param file name of the lesson without extension, "simple-pendulum"
Lesson with_course_texts(const Lesson& scene, std::string_view file);

}  // namespace jw::test
