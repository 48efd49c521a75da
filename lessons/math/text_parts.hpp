#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lessons/math/read_math.hpp"

/// Texts with formulas between dollar signs, and with text as typed in files between backticks.
namespace jw::math {

struct TextPart {
    enum class Kind {
        words,
        formula,  ///< $...$, within a line
        display,  ///< $$...$$, a line of its own
        code,     ///< `...`, as it is typed
    };
    Kind kind = Kind::words;
    std::string words;  ///< without escapes; for a formula, its source
    Row row;            ///< the formula, as far as it could be read
};

struct TextParts {
    std::vector<TextPart> parts;
    std::vector<Problem> problems;  ///< at bytes of the text
};

/// Parts of a text. `\$` is a dollar sign. An unpaired dollar sign is a problem, and the rest of the text is
/// words. A backtick without a second one in its line is a part of the words.
TextParts text_parts(std::string_view text);

/// True if the text consists of more than words.
bool has_marks(std::string_view text);

/// The text in plain Unicode, for terminals, tables and names; backticks stay.
std::string plain_words(std::string_view text);

}  // namespace jw::math
