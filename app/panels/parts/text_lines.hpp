#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/session/wording/text_width.hpp"

struct ImFont;

/// Lines of interface text: width, line breaks and shortening. Nothing is drawn here.
namespace jw::panels {

float text_width(const ImFont& font, std::string_view text);

/// Hyphens before digits become −, as in "x = -1.2e-07"; those that join words stay, as in "p1-2".
std::string with_minus_signs(std::string_view text);

/// Joins the lines of a text from a lesson's file; an empty line starts a new paragraph.
std::string run_on(std::string_view text);

/// Text in correct typography: "s_i" and "d_0" become "sᵢ" and "d₀", " - " becomes " – "; formulas between
/// dollar signs do not change.
std::string typeset(std::string_view text);

/// Lines no wider than `width`. They break at spaces (but not next to "·", "=" or "→"), between Chinese
/// characters (may_break_between), and within a word only if the word is wider than a line. Line feeds end
/// lines as well.
std::vector<std::string> wrapped(const ImFont& font, std::string_view text, float width);

/// `text` if it fits, else its beginning with "…".
std::string shortened(const ImFont& font, std::string_view text, float width);

/// Shortens a name in its middle, since names often differ at their end: "segment-7" becomes "segm…7".
std::string shortened_name(const ImFont& font, std::string_view name, float width);

/// Ends of sentences outside formulas, last first: places after ". ", "? ", "! ", "。", "？" and "！".
std::vector<std::size_t> sentence_ends(std::string_view text);

/// At most `most_lines` lines; text that does not fit is left out from the end of a sentence on, marked "…".
std::vector<std::string> wrapped_to(
    const ImFont& font, std::string_view text, float width, std::size_t most_lines);

}  // namespace jw::panels
