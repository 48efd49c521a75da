#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Characters of UTF-8.
namespace jw {

/// Number of bytes of the character at the start of `text`, 0 if it is not UTF-8.
std::size_t character_length(std::string_view text);

/// False for the second and later bytes of a character.
constexpr bool starts_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }

/// Text as one line that is safe to show on a terminal: control characters, which could move its cursor or
/// change its state, become blanks.
std::string printable(std::string_view text);

}  // namespace jw
