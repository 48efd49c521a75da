#pragma once

#include <string>
#include <vector>

#include "lessons/diagnostics/diagnostics.hpp"
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

/// What reading a file gives besides its contents.
struct FileRead {
    std::vector<Diagnostic> diagnostics;  ///< by position
    std::string source;                   ///< the file's text, for printing diagnostics
    std::vector<ReadText> texts;          ///< all texts for people in it, in the order of reading

    /// All diagnostics in compiler style.
    std::string report() const;
    /// Adds an error about the file as a whole.
    void blame(std::string file, Code code, std::string message);
};

/// A warning for each language that only some texts of the file have. It is placed at the first text without
/// it, and says how many there are and where. Texts that only authors see need no translation.
std::vector<Diagnostic> missing_translations(const std::string& file, const std::vector<ReadText>& texts);

}  // namespace jw
