#pragma once

#include <string>
#include <string_view>

/// Text as HTML, XML and Markdown.
namespace jw {

/// Text between tags or in an attribute: special characters escaped, U+FFFD for what XML does not allow.
std::string markup_text(std::string_view text);
/// Words with formulas between dollar signs as HTML with MathML.
std::string html_words(const std::string& words);
/// The same words as Markdown with formulas in LaTeX.
std::string markdown_words(const std::string& words);
}  // namespace jw
