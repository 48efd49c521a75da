#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Characters of UTF-8: how wide they are in a terminal, and where a line may end between them.
namespace jw {

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
