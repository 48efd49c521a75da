#include "app/exercises/answers/spelt_answer.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace jw {

namespace {

constexpr std::string_view kFullWidth = "\uFF01";

/// Unicode signs that stand for those of a keyboard.
constexpr std::array<std::pair<std::string_view, std::string_view>, 19> kSigns{
    {{"−", "-"},
     {"–", "-"},
     {"—", "-"},
     {"‐", "-"},
     {"×", "*"},
     {"**", "^"},
     {"·", "*"},
     {"⋅", "*"},
     {"÷", "/"},
     {"π", "pi"},
     {"√", "sqrt"},
     {"º", "°"},
     {"˚", "°"},
     {"、", ","},
     {"\u00A0", " "},
     {"\u2009", " "},
     {"\u202F", " "},
     {"\u3000", " "},
     {"\t", " "}}};

/// ASCII character of a full-width one, as East Asian keyboards write it: '0' for "０"; else '\0'.
char of_full_width(std::string_view text) {
    if (text.size() < kFullWidth.size() || text[0] != kFullWidth[0]) { return '\0'; }
    const auto page = static_cast<unsigned char>(text[1]);
    const auto last = static_cast<unsigned char>(text[2]);
    const int code = page == 0xBCU ? last - 0x60 : page == 0xBDU ? last - 0x20 : 0;
    return code > ' ' && code <= '~' ? static_cast<char>(code) : '\0';
}

}  // namespace

std::string with_signs_of_keyboard(std::string_view text) {
    std::string found;
    while (!text.empty()) {
        const auto* const sign =
            std::ranges::find_if(kSigns, [&](const auto& s) { return text.starts_with(s.first); });
        if (sign != kSigns.end()) {
            found += sign->second;
            text.remove_prefix(sign->first.size());
        } else if (const char c = of_full_width(text); c != '\0') {
            found += c;
            text.remove_prefix(kFullWidth.size());
        } else {
            found += text.front();
            text.remove_prefix(1);
        }
    }
    return found;
}

std::string with_decimal_points(std::string text, std::ptrdiff_t entries) {
    // parentheses around the whole text belong to a list; others may hold a list, or arguments
    const std::size_t first = text.find_first_not_of(' ');
    const bool is_list =
        first != std::string::npos && text[first] == '(' && text.find(')') == text.find_last_not_of(" \n\r");
    if (std::ranges::count(text, ';') + 1 != entries || text.find('.') != std::string::npos ||
        text.find('(', is_list ? first + 1 : 0) != std::string::npos) {
        return text;
    }
    const auto is_digit = [&](std::size_t k) { return k < text.size() && text[k] >= '0' && text[k] <= '9'; };
    bool before = false;
    for (std::size_t k = 0; k < text.size(); ++k) {
        if (text[k] == ';') { before = false; }
        if (text[k] != ',') { continue; }
        if (before || k == 0 || !is_digit(k - 1) || !is_digit(k + 1)) { return text; }
        before = true;
    }
    std::ranges::replace(text, ',', '.');
    return text;
}

}  // namespace jw
