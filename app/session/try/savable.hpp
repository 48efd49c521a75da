#pragma once

#include <string>

#include "lessons/lesson/lesson.hpp"

namespace jw {

/// Reason why a changed lesson could not be read again after it was saved. Empty if it could, or if the
/// lesson before the change could not be read either: whoever made that lesson does not save it.
std::string why_not_savable(const Lesson& changed, const Lesson& before);

}  // namespace jw
