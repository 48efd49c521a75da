#pragma once

#include "lessons/exercise/exercise.hpp"
#include "lessons/lesson.hpp"

namespace jw {

/// The lesson with its texts in the language of the reader (messages.hpp), as far as it has them.
Lesson shown_lesson(Lesson lesson);
Exercise shown_exercise(Exercise exercise);
/// Shows one text so.
Text shown_text(Text text);

}  // namespace jw
