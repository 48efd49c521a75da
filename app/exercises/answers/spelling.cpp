#include "app/exercises/answers/spelling.hpp"

#include <algorithm>
#include <cctype>
#include <numbers>
#include <utility>

#include "core/elementary/elementary.hpp"

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

struct UnitName {
    std::string_view name;
    WrittenUnit unit;
};

constexpr double kDegree = std::numbers::pi / 180.0;

// powers of m, kg, s, rad
constexpr std::array kUnits{
    UnitName{"deg", {kDegree, {0, 0, 0, 1}}},     UnitName{"°", {kDegree, {0, 0, 0, 1}}},
    UnitName{"degrees", {kDegree, {0, 0, 0, 1}}}, UnitName{"rad", {1.0, {0, 0, 0, 1}}},
    UnitName{"m", {1.0, {1, 0, 0, 0}}},           UnitName{"cm", {0.01, {1, 0, 0, 0}}},
    UnitName{"mm", {0.001, {1, 0, 0, 0}}},        UnitName{"s", {1.0, {0, 0, 1, 0}}},
    UnitName{"ms", {0.001, {0, 0, 1, 0}}},        UnitName{"kg", {1.0, {0, 1, 0, 0}}},
    UnitName{"g", {0.001, {0, 1, 0, 0}}},         UnitName{"N", {1.0, {1, 1, -2, 0}}},
    UnitName{"kN", {1000.0, {1, 1, -2, 0}}},      UnitName{"J", {1.0, {2, 1, -2, 0}}},
    UnitName{"Hz", {1.0, {0, 0, -1, 0}}}};

/// Takes a power from the front: "^2", "²", "^-1".
int take_power(std::string_view& text) {
    for (const auto& [sign, power] : {std::pair<std::string_view, int>{"²", 2}, {"³", 3}}) {
        if (text.starts_with(sign)) {
            text.remove_prefix(sign.size());
            return power;
        }
    }
    if (text.empty()) { return 1; }
    const bool caret = text.front() == '^';
    if (caret) { text.remove_prefix(1); }
    const bool minus = caret && !text.empty() && text.front() == '-';
    if (minus) { text.remove_prefix(1); }
    if (text.empty() || text.front() < '1' || text.front() > '4') { return caret ? 0 : 1; }
    const int power = text.front() - '0';
    text.remove_prefix(1);
    return minus ? -power : power;
}

bool is_part_of_word(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80U;
}

/// Takes a unit name from the front.
const UnitName* take_name(std::string_view& text) {
    const UnitName* best = nullptr;
    for (const UnitName& unit : kUnits) {
        if (!text.starts_with(unit.name)) { continue; }
        if (best == nullptr || unit.name.size() > best->name.size()) { best = &unit; }
    }
    if (best == nullptr) { return nullptr; }
    const std::string_view rest = text.substr(best->name.size());
    const bool power = rest.starts_with("²") || rest.starts_with("³") || rest.starts_with("·");
    if (!rest.empty() && is_part_of_word(rest.front()) && !power) { return nullptr; }
    text = rest;
    return best;
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

std::optional<WrittenUnit> read_unit(std::string_view text) {
    WrittenUnit unit;
    int side = 1;
    while (!text.empty()) {
        if (text.front() == ' ' || text.front() == '*') {
            text.remove_prefix(1);
        } else if (text.starts_with("·")) {
            text.remove_prefix(std::string_view("·").size());
        } else if (text.front() == '/') {
            if (side < 0) { return std::nullopt; }
            side = -1;
            text.remove_prefix(1);
        } else {
            const UnitName* const name = take_name(text);
            if (name == nullptr) { return std::nullopt; }
            const int power = side * take_power(text);
            if (power == 0) { return std::nullopt; }
            unit.factor *= elementary::pow(name->unit.factor, power);
            for (std::size_t k = 0; k < unit.powers.size(); ++k) {
                unit.powers[k] += power * name->unit.powers[k];
            }
        }
    }
    return unit;
}

}  // namespace jw
