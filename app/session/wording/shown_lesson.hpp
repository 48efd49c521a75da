#pragma once

#include "lessons/lesson/exercise.hpp"
#include "lessons/lesson/lesson.hpp"

namespace jw {

/// The lesson with its texts in the language of the reader (messages.hpp), where it has them.
Lesson shown_lesson(Lesson lesson);
Exercise shown_exercise(Exercise exercise);
/// The same for one text.
Text shown_text(Text text);
/// The source of a lesson, an exercise or a mistake: "slides 8, 23" is the message "slides {0}". Only its
/// first word is translated: what follows are numbers, and titles of books.
std::string shown_slides(const std::string& source);

}  // namespace jw
