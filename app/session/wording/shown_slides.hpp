#pragma once

#include <string>

namespace jw {

/// The source of a lesson, an exercise or a mistake for the reader: "slides 8, 23" is the message "slides
/// {0}". Only its first word is translated: what follows are numbers, and titles of books.
std::string shown_slides(const std::string& source);

}  // namespace jw
