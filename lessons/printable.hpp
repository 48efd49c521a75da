#pragma once

#include <string>
#include <string_view>

namespace jw {

/// Text as one line that a terminal only shows: control characters, which would move its cursor or change its
/// state, are blanks.
std::string printable(std::string_view text);

}  // namespace jw
