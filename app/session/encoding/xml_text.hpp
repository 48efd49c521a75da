#pragma once

#include <string>
#include <string_view>

namespace jw {

/// `text` between two tags: special characters of XML escaped; U+FFFD for what XML 1.0 does not allow
/// (control characters, bytes that are not UTF-8).
std::string xml_text(std::string_view text);
/// Text of an attribute in double quotes: line ends and tabs are escaped, too, since they would be read as
/// blanks.
std::string xml_attribute(std::string_view text);

}  // namespace jw
