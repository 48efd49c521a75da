#pragma once

#include <cstddef>
#include <string_view>

namespace jw {

/// Number of bytes of the character at the start of `text`, 0 if it is not UTF-8.
std::size_t character_length(std::string_view text);

}  // namespace jw
