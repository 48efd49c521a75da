#include "app/exercises/run/safe_text.hpp"

#include <algorithm>
#include <cstdio>

namespace jw::exercises {
namespace {

struct Character {
    unsigned long code = 0;
    std::size_t length = 0;  ///< 0: no valid character begins here
};

bool continues(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

/// The first character of a text that is not empty, by the table of well-formed UTF-8.
Character first_character(std::string_view text) {
    const auto lead = static_cast<unsigned char>(text[0]);
    if (lead < 0x80) { return {lead, 1}; }
    const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || text.size() < length) { return {}; }
    unsigned long code = lead & (0x7FU >> length);
    for (std::size_t k = 1; k < length; ++k) {
        if (!continues(text[k])) { return {}; }
        code = (code << 6U) | (static_cast<unsigned char>(text[k]) & 0x3FU);
    }
    const bool too_long = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
    const bool no_character = code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF);
    return too_long || no_character ? Character{} : Character{code, length};
}

/// True for codes that control a terminal, or the direction in which a text is read.
bool controls(unsigned long code) {
    if (code == '\n' || code == '\t') { return false; }
    const bool is_control = code < 0x20 || (code >= 0x7F && code < 0xA0);
    const bool is_direction = (code >= 0x200E && code <= 0x200F) || (code >= 0x2028 && code <= 0x202E) ||
                              (code >= 0x2066 && code <= 0x2069) || code == 0x61C;
    return is_control || is_direction;
}

std::string hexadecimal(const char* format, unsigned long value) {
    char text[16];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

}  // namespace

std::string printable(std::string_view bytes) {
    std::string text;
    while (!bytes.empty()) {
        const Character next = first_character(bytes);
        if (next.length == 0) {
            text += hexadecimal("\\x%02lx", static_cast<unsigned char>(bytes[0]));
        } else if (!controls(next.code)) {
            text += bytes.substr(0, next.length);
        } else {
            text += hexadecimal(next.code < 0x80 ? "\\x%02lx" : "\\u{%lx}", next.code);
        }
        bytes.remove_prefix(std::max<std::size_t>(next.length, 1));
    }
    return text;
}

std::string first_lines(std::string_view text, std::size_t lines, std::size_t width) {
    std::string result;
    while (text.ends_with('\n')) { text.remove_suffix(1); }
    for (std::size_t k = 0; k < lines && !text.empty(); ++k) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::size_t shown = std::min(end, width);
        while (shown > 0 && shown < end && continues(text[shown])) { --shown; }
        if (k > 0) { result += '\n'; }
        result += text.substr(0, shown);
        if (shown < end) { result += "..."; }
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    if (!text.empty()) { result += "\n..."; }
    return result;
}

}  // namespace jw::exercises
