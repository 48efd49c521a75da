#pragma once

#include <string_view>

#include "lessons/lesson/lesson.hpp"

/// Lessons that come with the program, as material of the cases.
namespace jw::hard {

/// @param name below lessons/catalogue
/// @throws std::runtime_error if it cannot be read
Lesson shipped_lesson(std::string_view name);

/// The lesson assembled joint by joint, as it is told.
/// @throws std::runtime_error if it does not close
State assembled(const Lesson& lesson);

}  // namespace jw::hard
