#pragma once

#include <string>
#include <string_view>

/// Language tags: BCP 47, as far as a text needs them.
namespace jw {

/// True for a language of two or three letters with, at most, a script, a region and variants, each in the
/// case that the standard recommends: "de", "pt-BR", "zh-Hant", "zh-Hant-TW", "de-CH-1996".
/// @source RFC 5646, sections 2.1 and 2.1.1
bool is_language_tag(std::string_view text);

/// The tag that was probably meant: another case, or underscores between its parts; empty if there is none.
std::string meant_language_tag(std::string_view text);

}  // namespace jw
