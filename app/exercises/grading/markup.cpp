#include "app/exercises/grading/markup.hpp"

#include <algorithm>

#include "lessons/math/text_parts.hpp"
#include "lessons/math/write_math.hpp"

namespace jw {

namespace {

/// "Char" of XML 1.0 beyond ASCII, written with as few bytes as it has.
bool is_allowed(char32_t c, std::size_t bytes) {
    const bool is_short = c >= (bytes == 2 ? 0x80U : bytes == 3 ? 0x800U : 0x10000U);
    return is_short && (c <= 0xD7FFU || (c >= 0xE000U && c <= 0xFFFDU) || (c >= 0x10000U && c <= 0x10FFFFU));
}

/// Bytes of the UTF-8 character at the front, 0 if it is none, or none that XML allows.
std::size_t utf8_length(std::string_view text) {
    const auto first = static_cast<unsigned char>(text.front());
    if (first < 0x80U) { return 1; }
    const std::size_t length = first >= 0xF0U ? 4 : first >= 0xE0U ? 3 : 2;
    if (first < 0xC2U || first > 0xF4U || length > text.size()) { return 0; }
    char32_t value = first & (0x7FU >> length);
    for (std::size_t k = 1; k < length; ++k) {
        const auto next = static_cast<unsigned char>(text[k]);
        if ((next & 0xC0U) != 0x80U) { return 0; }
        value = (value << 6U) | (next & 0x3FU);
    }
    return is_allowed(value, length) ? length : 0;
}

}  // namespace

std::string markup_text(std::string_view text) {
    std::string shown;
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        const char c = text.front();
        const bool control = static_cast<unsigned char>(c) < 0x20U && c != '\n' && c != '\t';
        if (length == 0 || control || c == '\x7f') {
            shown += "\xEF\xBF\xBD";
        } else if (c == '&' || c == '<' || c == '>' || c == '"' || c == '\'') {
            shown += c == '&'   ? "&amp;"
                     : c == '<' ? "&lt;"
                     : c == '>' ? "&gt;"
                     : c == '"' ? "&quot;"
                                : "&#39;";
        } else {
            shown += text.substr(0, length);
        }
        text.remove_prefix(std::max<std::size_t>(1, length));
    }
    return shown;
}

std::string html_words(const std::string& words) {
    std::string html;
    for (const math::TextPart& part : math::text_parts(words).parts) {
        if (part.kind == math::TextPart::Kind::words) {
            for (const char c : markup_text(part.words)) {
                html += c == '\n' ? std::string("<br>\n") : std::string(1, c);
            }
        } else {
            html += math::write_mathml(part.row, part.kind == math::TextPart::Kind::display);
        }
    }
    return html;
}

std::string markdown_words(const std::string& words) {
    std::string text;
    for (const math::TextPart& part : math::text_parts(words).parts) {
        if (part.kind == math::TextPart::Kind::words) {
            text += part.words;
        } else {
            const std::string mark = part.kind == math::TextPart::Kind::display ? "$$" : "$";
            text += mark + math::write_latex(part.row) + mark;
        }
    }
    return text;
}

}  // namespace jw
