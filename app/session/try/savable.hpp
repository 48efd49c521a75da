#pragma once

#include <string>

#include "lessons/lesson.hpp"

namespace jw {

/// Why a changed lesson could not be read again after it was saved; empty if it could, or if the one before
/// could not either: whoever made that does not save lessons.
std::string why_not_savable(const Lesson& changed, const Lesson& before);

}  // namespace jw
