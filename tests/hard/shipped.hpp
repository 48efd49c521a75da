#pragma once

#include <string_view>

#include "lessons/lesson/lesson.hpp"

/// Lessons that come with the program, for the hard cases.
namespace jw::hard {

/// @param name below lessons/catalogue
/// @throws std::runtime_error if it cannot be read
Lesson shipped_lesson(std::string_view name);

/// State at the end of the lesson's story, which assembles it joint by joint.
/// @throws std::runtime_error if it does not close
State assembled(const Lesson& lesson);

}  // namespace jw::hard
