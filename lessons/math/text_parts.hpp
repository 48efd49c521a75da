#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lessons/math/read_math.hpp"

/// Texts with formulas between dollar signs, and what stands in files between backticks.
namespace jw::math {

struct TextPart {
    enum class Kind {
        words,
        formula,  ///< $...$, within a line
        display,  ///< $$...$$, a line of its own
        code,     ///< `...`, as it is typed
    };
    Kind kind = Kind::words;
    std::string words;  ///< without escapes; of a formula its source
    Row row;            ///< of a formula; what could be read of it
};

struct TextParts {
    std::vector<TextPart> parts;
    std::vector<Problem> problems;  ///< at bytes of the text
};

/// `\$` is a dollar sign. A dollar sign without its second one is a problem, and the rest is words; a
/// backtick without its second one in the line is words.
TextParts text_parts(std::string_view text);

/// True if there is more than words in the text.
bool has_marks(std::string_view text);

/// The text in Unicode alone, for terminals, tables and names; backticks stay.
std::string plain_words(std::string_view text);

}  // namespace jw::math
