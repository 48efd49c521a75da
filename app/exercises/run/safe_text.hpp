#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace jw::exercises {

/// Any bytes as text that is harmless in a terminal: valid UTF-8 without control characters except line feeds
/// and tabs. All other bytes, and characters that change the direction of writing, become \xNN or \u{NNNN}.
std::string printable(std::string_view bytes);

/// The first lines of a text, each cut after `width` bytes but never within a character; "..." stands for
/// what is left out.
std::string first_lines(std::string_view text, std::size_t lines, std::size_t width);

}  // namespace jw::exercises
