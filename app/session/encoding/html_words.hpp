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
/// `text` between two tags: special characters of XML escaped; U+FFFD for what XML 1.0 does not allow
/// (control characters, bytes that are not UTF-8).
std::string xml_text(std::string_view text);
/// Text of an attribute in double quotes: line ends and tabs are escaped, too, since they would be read as
/// blanks.
std::string xml_attribute(std::string_view text);

}  // namespace jw
