#include "app/session/wording/text_width.hpp"

#include <cstddef>
#include <sstream>
#include <string_view>

#include "app/session/wording/character_classes.hpp"

namespace jw {

int displayed_width(const std::string& text) {
    int columns = 0;
    for (const char32_t c : from_utf8(text)) {
        const bool combining = c >= 0x300 && c < 0x370;
        columns += combining ? 0 : is_wide(c) ? 2 : 1;
    }
    return columns;
}

std::string padded(const std::string& text, int width, bool right) {
    const int missing = width - displayed_width(text);
    if (missing <= 0) { return text; }
    const std::string spaces(static_cast<std::size_t>(missing), ' ');
    return right ? spaces + text : text + spaces;
}

std::string wrapped(const std::string& text, int width, int indent) {
    std::string out;
    int column = 0;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        bool behind_space = true;
        for (const std::string_view part : parts_to_break(word)) {
            const int length = displayed_width(std::string(part));
            const int space = column > 0 && behind_space ? 1 : 0;
            if (column > 0 && column + space + length > width) {
                out += '\n' + std::string(static_cast<std::size_t>(indent), ' ');
                column = 0;
            } else {
                out += std::string(static_cast<std::size_t>(space), ' ');
                column += space;
            }
            out += part;
            column += length;
            behind_space = false;
        }
    }
    return out;
}

std::string labelled(const std::string& label, const std::string& text, int width) {
    const int indent = displayed_width(label) + 3;
    return "  " + label + ' ' + wrapped(text, width - indent, indent) + '\n';
}

std::string in_one_line(const std::string& text) {
    std::string line;
    for (const char c : text) {
        const bool is_blank = c == '\n' || c == '\r' || c == '\t' || c == ' ';
        if (is_blank && (line.empty() || line.back() == ' ')) { continue; }
        line += is_blank ? ' ' : c;
    }
    if (line.ends_with(' ')) { line.pop_back(); }
    return line;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size()) {
        text.replace(at, what.size(), by);
    }
    return text;
}

}  // namespace jw
