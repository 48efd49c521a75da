#include "app/session/wording/text_width.hpp"

#include <cstddef>
#include <sstream>

namespace jw {

int displayed_width(const std::string& text) {
    int count = 0;
    for (std::size_t k = 0; k < text.size(); ++k) {
        const auto c = static_cast<unsigned char>(text[k]);
        if ((c & 0xC0U) == 0x80U) { continue; }
        const bool combining =
            c == 0xCC || (c == 0xCD && k + 1 < text.size() && static_cast<unsigned char>(text[k + 1]) < 0xB0);
        count += combining ? 0 : 1;
    }
    return count;
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
        const int length = displayed_width(word);
        if (column > 0 && column + 1 + length > width) {
            out += '\n' + std::string(static_cast<std::size_t>(indent), ' ');
            column = 0;
        }
        if (column > 0) {
            out += ' ';
            ++column;
        }
        out += word;
        column += length;
    }
    return out;
}

std::string labelled(const std::string& label, const std::string& text, int width) {
    const int indent = displayed_width(label) + 3;
    return "  " + label + ' ' + wrapped(text, width - indent, indent) + '\n';
}

}  // namespace jw
