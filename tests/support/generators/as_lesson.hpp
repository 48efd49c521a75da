#pragma once

#include <string>

#include "lessons/lesson/lesson.hpp"
#include "tests/support/generators/mechanism_of.hpp"

/// Generated mechanisms as lesson files that the program opens.
namespace jw::test {

/// Every joint and driver in the order of the recipe; the point is the origin of the last body.
Lesson lesson_of(const Generated& generated, const std::string& title, const std::string& text);

}  // namespace jw::test
