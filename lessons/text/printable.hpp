#pragma once

#include <string>
#include <string_view>

namespace jw {

/// Text as one line that is safe to show on a terminal: control characters, which could move its cursor or
/// change its state, become blanks.
std::string printable(std::string_view text);

}  // namespace jw
