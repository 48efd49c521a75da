#pragma once

#include <string>

#include "lessons/diagnostics/source_span.hpp"
#include "lessons/text/text.hpp"

/// Texts with their places, for checks of all texts of a file.
namespace jw {

/// Who reads a text: students in the window and the pictures, or authors only, as `jointwise check` shows it.
enum class Audience { students, authors };

/// A text for people as it was read from a file.
struct ReadText {
    std::string table;  ///< "the lesson", "revolute joint 'hinge'"
    std::string key;    ///< "text"
    SourceSpan span;    ///< of the text in the language of the lesson
    Text text;
    Audience audience = Audience::students;
};

}  // namespace jw
