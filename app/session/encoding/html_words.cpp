#include "app/session/encoding/html_words.hpp"

#include "lessons/math/text_parts.hpp"
#include "lessons/math/write_math.hpp"

namespace jw {

namespace {

constexpr const char* kNotAllowed = "\xEF\xBF\xBD";  // U+FFFD

struct CodePoint {
    char32_t value = 0;
    std::size_t bytes = 0;  ///< 0: this is not UTF-8
};

/// The smallest code point that needs this many bytes; smaller ones must be written with fewer.
char32_t least_of(std::size_t bytes) { return bytes == 2 ? 0x80U : (bytes == 3 ? 0x800U : 0x10000U); }

/// The first character of `text`, which is not empty.
CodePoint first_of(std::string_view text) {
    const auto first = static_cast<unsigned char>(text.front());
    if (first < 0x80U) { return {first, 1}; }
    const std::size_t bytes = first >= 0xF0U ? 4 : (first >= 0xE0U ? 3 : 2);
    if (first < 0xC0U || first > 0xF4U || bytes > text.size()) { return {}; }
    char32_t value = first & (0x7FU >> bytes);
    for (std::size_t k = 1; k < bytes; ++k) {
        const auto next = static_cast<unsigned char>(text[k]);
        if ((next & 0xC0U) != 0x80U) { return {}; }
        value = (value << 6U) | (next & 0x3FU);
    }
    return value < least_of(bytes) ? CodePoint{} : CodePoint{value, bytes};
}

/// True for a "Char" of XML 1.0.
bool is_allowed(char32_t c) {
    if (c < 0x20U) { return c == '\t' || c == '\n' || c == '\r'; }
    return c <= 0xD7FFU || (c >= 0xE000U && c <= 0xFFFDU) || (c >= 0x10000U && c <= 0x10FFFFU);
}

std::string escaped(std::string_view text, bool in_quotes) {
    std::string out;
    while (!text.empty()) {
        const CodePoint c = first_of(text);
        const std::size_t bytes = c.bytes == 0 ? 1 : c.bytes;
        if (c.bytes == 0 || !is_allowed(c.value)) {
            out += kNotAllowed;
        } else if (c.value == '&') {
            out += "&amp;";
        } else if (c.value == '<') {
            out += "&lt;";
        } else if (c.value == '>') {
            out += "&gt;";
        } else if (c.value == '"' && in_quotes) {
            out += "&quot;";
        } else if (c.value == '\r' || (in_quotes && c.value < 0x20U)) {
            out += "&#" + std::to_string(static_cast<unsigned>(c.value)) + ';';
        } else {
            out += text.substr(0, bytes);
        }
        text.remove_prefix(bytes);
    }
    return out;
}

}  // namespace

std::string markup_text(std::string_view text) {
    std::string shown;
    for (const char c : xml_text(text)) {
        // both kinds of quotes, since the text may be an attribute
        shown += c == '"' ? std::string("&quot;") : c == '\'' ? std::string("&#39;") : std::string(1, c);
    }
    return shown;
}

std::string html_words(const std::string& words) {
    std::string html;
    for (const math::TextPart& part : math::text_parts(words).parts) {
        switch (part.kind) {
            case math::TextPart::Kind::words:
                for (const char c : markup_text(part.words)) {
                    html += c == '\n' ? std::string("<br>\n") : std::string(1, c);
                }
                break;
            case math::TextPart::Kind::code: html += "<code>" + markup_text(part.words) + "</code>"; break;
            case math::TextPart::Kind::formula: html += math::write_mathml(part.row, false); break;
            case math::TextPart::Kind::display: html += math::write_mathml(part.row, true); break;
        }
    }
    return html;
}

std::string markdown_words(const std::string& words) {
    std::string text;
    for (const math::TextPart& part : math::text_parts(words).parts) {
        switch (part.kind) {
            case math::TextPart::Kind::words: text += part.words; break;
            case math::TextPart::Kind::code: text += '`' + part.words + '`'; break;
            case math::TextPart::Kind::formula: text += '$' + math::write_latex(part.row) + '$'; break;
            case math::TextPart::Kind::display: text += "$$" + math::write_latex(part.row) + "$$"; break;
        }
    }
    return text;
}

std::string xml_text(std::string_view text) { return escaped(text, false); }
std::string xml_attribute(std::string_view text) { return escaped(text, true); }

}  // namespace jw
