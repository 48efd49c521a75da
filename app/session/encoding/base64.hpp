#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace jw {

/// Bytes as text, for files inside HTML and XML. @source RFC 4648, section 4
std::string base64(std::span<const std::uint8_t> bytes);

/// `text` as a part of a URL: every byte except ASCII letters, digits and the bytes of `plain` becomes %XX.
std::string percent_encoded(std::string_view text, std::string_view plain);

}  // namespace jw
