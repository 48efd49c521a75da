#include "app/session/wording/text_width.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <sstream>
#include <string_view>

namespace jw {

namespace {

constexpr char32_t kUnreadable = 0xFFFD;

struct Range {
    char32_t first;
    char32_t last;
};

// East Asian Width W and F of Unicode 14.0.0, neighbours joined; written from EastAsianWidth.txt
constexpr std::array<Range, 110> kWide{
    {{0x1100, 0x115F},   {0x231A, 0x231B},   {0x2329, 0x232A},   {0x23E9, 0x23EC},   {0x23F0, 0x23F0},
     {0x23F3, 0x23F3},   {0x25FD, 0x25FE},   {0x2614, 0x2615},   {0x2648, 0x2653},   {0x267F, 0x267F},
     {0x2693, 0x2693},   {0x26A1, 0x26A1},   {0x26AA, 0x26AB},   {0x26BD, 0x26BE},   {0x26C4, 0x26C5},
     {0x26CE, 0x26CE},   {0x26D4, 0x26D4},   {0x26EA, 0x26EA},   {0x26F2, 0x26F3},   {0x26F5, 0x26F5},
     {0x26FA, 0x26FA},   {0x26FD, 0x26FD},   {0x2705, 0x2705},   {0x270A, 0x270B},   {0x2728, 0x2728},
     {0x274C, 0x274C},   {0x274E, 0x274E},   {0x2753, 0x2755},   {0x2757, 0x2757},   {0x2795, 0x2797},
     {0x27B0, 0x27B0},   {0x27BF, 0x27BF},   {0x2B1B, 0x2B1C},   {0x2B50, 0x2B50},   {0x2B55, 0x2B55},
     {0x2E80, 0x303E},   {0x3041, 0x3247},   {0x3250, 0x4DBF},   {0x4E00, 0xA4C6},   {0xA960, 0xA97C},
     {0xAC00, 0xD7A3},   {0xF900, 0xFAD9},   {0xFE10, 0xFE19},   {0xFE30, 0xFE52},   {0xFE54, 0xFE66},
     {0xFE68, 0xFE6B},   {0xFF01, 0xFF60},   {0xFFE0, 0xFFE6},   {0x16FE0, 0x16FE4}, {0x16FF0, 0x16FF1},
     {0x17000, 0x187F7}, {0x18800, 0x18CD5}, {0x18D00, 0x18D08}, {0x1AFF0, 0x1AFF3}, {0x1AFF5, 0x1AFFB},
     {0x1AFFD, 0x1AFFE}, {0x1B000, 0x1B122}, {0x1B150, 0x1B152}, {0x1B164, 0x1B167}, {0x1B170, 0x1B2FB},
     {0x1F004, 0x1F004}, {0x1F0CF, 0x1F0CF}, {0x1F18E, 0x1F18E}, {0x1F191, 0x1F19A}, {0x1F200, 0x1F202},
     {0x1F210, 0x1F23B}, {0x1F240, 0x1F248}, {0x1F250, 0x1F251}, {0x1F260, 0x1F265}, {0x1F300, 0x1F320},
     {0x1F32D, 0x1F335}, {0x1F337, 0x1F37C}, {0x1F37E, 0x1F393}, {0x1F3A0, 0x1F3CA}, {0x1F3CF, 0x1F3D3},
     {0x1F3E0, 0x1F3F0}, {0x1F3F4, 0x1F3F4}, {0x1F3F8, 0x1F43E}, {0x1F440, 0x1F440}, {0x1F442, 0x1F4FC},
     {0x1F4FF, 0x1F53D}, {0x1F54B, 0x1F54E}, {0x1F550, 0x1F567}, {0x1F57A, 0x1F57A}, {0x1F595, 0x1F596},
     {0x1F5A4, 0x1F5A4}, {0x1F5FB, 0x1F64F}, {0x1F680, 0x1F6C5}, {0x1F6CC, 0x1F6CC}, {0x1F6D0, 0x1F6D2},
     {0x1F6D5, 0x1F6D7}, {0x1F6DD, 0x1F6DF}, {0x1F6EB, 0x1F6EC}, {0x1F6F4, 0x1F6FC}, {0x1F7E0, 0x1F7EB},
     {0x1F7F0, 0x1F7F0}, {0x1F90C, 0x1F93A}, {0x1F93C, 0x1F945}, {0x1F947, 0x1F9FF}, {0x1FA70, 0x1FA74},
     {0x1FA78, 0x1FA7C}, {0x1FA80, 0x1FA86}, {0x1FA90, 0x1FAAC}, {0x1FAB0, 0x1FABA}, {0x1FAC0, 0x1FAC5},
     {0x1FAD0, 0x1FAD9}, {0x1FAE0, 0x1FAE7}, {0x1FAF0, 0x1FAF6}, {0x20000, 0x2FFFD}, {0x30000, 0x3FFFD}}};

// a line must not begin with one of these
constexpr std::u32string_view kClosing =
    U",.;:!?)]}%…–—’”·、。〃々〉》」』】〕〗〙〛〞〟〻ー・！％），．：；？］｝～｠｡｣､･￠℃°";
// a line must not end with one of these
constexpr std::u32string_view kOpening = U"([{‘“〈《「『【〔〖〘〚〝（［｛｟｢＄￥";

bool is_one_of(std::u32string_view characters, char32_t c) {
    return characters.find(c) != std::u32string_view::npos;
}

/// Bytes of the character that starts with `first`; 0 if none does.
std::size_t length_of(unsigned char first) {
    if (first < 0x80) { return 1; }
    if (first >= 0xC2 && first < 0xE0) { return 2; }
    if (first >= 0xE0 && first < 0xF0) { return 3; }
    return first >= 0xF0 && first < 0xF5 ? 4 : 0;
}

struct Decoded {
    char32_t point = kUnreadable;
    std::size_t bytes = 1;
};

Decoded decode(std::string_view text, std::size_t at) {
    const auto first = static_cast<unsigned char>(text[at]);
    const std::size_t bytes = length_of(first);
    if (bytes == 0 || at + bytes > text.size()) { return {}; }
    char32_t point = bytes == 1 ? first : first & (0x7FU >> bytes);
    for (std::size_t b = 1; b < bytes; ++b) {
        point = (point << 6U) | (static_cast<unsigned char>(text[at + b]) & 0x3FU);
    }
    return {point, bytes};
}

}  // namespace

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

std::u32string from_utf8(std::string_view text) {
    std::u32string points;
    points.reserve(text.size());
    for (std::size_t k = 0; k < text.size();) {
        const Decoded character = decode(text, k);
        points += character.point;
        k += character.bytes;
    }
    return points;
}

bool is_wide(char32_t c) {
    if (c < kWide.front().first) { return false; }
    const auto* const found = std::ranges::lower_bound(kWide, c, {}, &Range::last);
    return found != kWide.end() && found->first <= c;
}

bool may_break_between(char32_t left, char32_t right) {
    return (is_wide(left) || is_wide(right)) && !is_one_of(kOpening, left) && !is_one_of(kClosing, right);
}

std::vector<std::string_view> parts_to_break(std::string_view word) {
    std::vector<std::string_view> parts;
    // most words have only ASCII letters: a quick answer, since every frame breaks its lines again
    const auto is_ascii = [](char c) { return static_cast<unsigned char>(c) < 0x80U; };
    if (!word.empty() && std::ranges::all_of(word, is_ascii)) { return {word}; }
    std::size_t begin = 0;
    char32_t before = 0;
    for (std::size_t k = 0; k < word.size();) {
        const Decoded character = decode(word, k);
        if (k > 0 && may_break_between(before, character.point)) {
            parts.push_back(word.substr(begin, k - begin));
            begin = k;
        }
        before = character.point;
        k += character.bytes;
    }
    if (begin < word.size()) { parts.push_back(word.substr(begin)); }
    return parts;
}

}  // namespace jw
