#pragma once

#include <string>
#include <string_view>
#include <vector>

/// UTF-8 text in a terminal, measured and broken by its displayed width.
namespace jw {

/// Columns on the screen: two for a wide character, none for a combining mark.
int displayed_width(const std::string& text);

/// `text` filled with spaces to a displayed width of `width`: after it, or before it if `right`.
std::string padded(const std::string& text, int width, bool right = false);

/// `text` broken at spaces, and between Chinese characters, into lines of at most `width` columns where words
/// allow; every line after the first is indented by `indent` spaces.
std::string wrapped(const std::string& text, int width, int indent);

/// A line "  label text"; if it is wrapped, the other lines begin under the text.
std::string labelled(const std::string& label, const std::string& text, int width);

/// Text in one line: the line breaks of a lesson's file are those of its author's editor.
std::string in_one_line(const std::string& text);

/// `text` with `by` in place of every `what`, which is not empty.
std::string replaced(std::string text, const std::string& what, const std::string& by);

/// Code points of UTF-8; anything malformed is U+FFFD.
std::u32string from_utf8(std::string_view text);

/// True if a terminal shows it two columns wide: East Asian Width W or F.
/// @source Unicode 14.0.0, EastAsianWidth.txt
bool is_wide(char32_t c);

/// True if a line may end between two characters without a space: where one of them is Chinese, but not
/// before a closing mark (，。、：；？！」） and the like) and not after an opening one (「（).
/// @source Unicode Standard Annex 14, classes CL, CP, EX, IS, NS, OP
bool may_break_between(char32_t left, char32_t right);

/// The parts of a word between which a line may end, in order; together they are the word. Latin words are
/// one part.
std::vector<std::string_view> parts_to_break(std::string_view word);

}  // namespace jw
