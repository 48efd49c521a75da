#pragma once

#include <string>
#include <string_view>

namespace jw {

/// `text` for a part of a URL: every byte but ASCII letters, digits and those of `plain` as %XX.
std::string percent_encoded(std::string_view text, std::string_view plain);

}  // namespace jw
