#include "lessons/text/utf8.hpp"

#include <algorithm>

namespace jw {

std::size_t character_length(std::string_view text) {
    const auto byte = [&](std::size_t k) {
        return k < text.size() ? static_cast<unsigned>(static_cast<unsigned char>(text[k])) : 0U;
    };
    const unsigned first = byte(0);
    if (first < 0x80U) { return 1; }
    const std::size_t length = first >= 0xF0U ? 4 : first >= 0xE0U ? 3 : 2;
    if (first < 0xC2U || first > 0xF4U || length > text.size()) { return 0; }
    for (std::size_t k = 1; k < length; ++k) {
        if ((byte(k) & 0xC0U) != 0x80U) { return 0; }
    }
    // overlong forms, surrogates and what lies beyond U+10FFFF
    const bool wrong = (first == 0xE0U && byte(1) < 0xA0U) || (first == 0xEDU && byte(1) > 0x9FU) ||
                       (first == 0xF0U && byte(1) < 0x90U) || (first == 0xF4U && byte(1) > 0x8FU);
    return wrong ? 0 : length;
}

std::string printable(std::string_view text) {
    std::string out(text);
    std::ranges::replace_if(
        out, [](char c) { return static_cast<unsigned char>(c) < 0x20U || c == '\x7f'; }, ' ');
    // U+0080 to U+009F: some terminals take U+009B for the beginning of a command
    for (std::size_t k = 0; k + 1 < out.size(); ++k) {
        const bool control = out[k] == '\xc2' && static_cast<unsigned char>(out[k + 1]) < 0xA0U;
        if (control) { out.replace(k, 2, "  "); }
    }
    return out;
}

}  // namespace jw
