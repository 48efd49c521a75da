#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace jw::exercises {

/// Any bytes as text that a terminal only shows: valid UTF-8 without control characters but line feeds and
/// tabs. What is neither, or turns the direction of writing, becomes \xNN, or \u{NNNN}.
std::string printable(std::string_view bytes);

/// The first lines of a text, each cut after `width` bytes, never within a character; "..." stands for what
/// is left out.
std::string first_lines(std::string_view text, std::size_t lines, std::size_t width);

}  // namespace jw::exercises
