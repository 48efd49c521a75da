#pragma once

#include <string>
#include <string_view>

namespace jw {

/// `text` as a part of a URL: every byte except ASCII letters, digits and the bytes of `plain` becomes %XX.
std::string percent_encoded(std::string_view text, std::string_view plain);

}  // namespace jw
