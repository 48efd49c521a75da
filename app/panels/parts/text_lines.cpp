#include "app/panels/parts/text_lines.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include <imgui.h>

#include "render/fonts/math_alphabets.hpp"

namespace jw::panels {

namespace {

/// True for characters of a word in ASCII; false for bytes of other characters, so θ_0 counts as one letter.
bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Number of bytes of the character that starts with `first`; 0 if none starts with it.
std::size_t bytes_of(unsigned char first) {
    if (first < 0x80) { return 1; }
    if (first >= 0xC2 && first < 0xE0) { return 2; }
    if (first >= 0xE0 && first < 0xF0) { return 3; }
    return first >= 0xF0 && first < 0xF5 ? 4 : 0;
}

/// True if the hyphen at `k` is the sign of a number or of an exponent.
bool is_minus(std::string_view text, std::size_t k) {
    if (k + 1 >= text.size() || !is_digit(text[k + 1])) { return false; }
    if (k == 0) { return true; }
    const char before = text[k - 1];
    if (before == 'e') { return k >= 2 && is_digit(text[k - 2]); }
    return before == ' ' || before == '(' || before == '=' || before == '\n';
}

/// True if a line may end between these two words.
bool breaks_between(std::string_view left, std::string_view right) {
    const auto binds = [](std::string_view word) {
        return word == "·" || word == "=" || word == "→" || word == "−";
    };
    return !binds(left) && !binds(right) && left != "Φq";
}

/// A unit that stays on one line: words, or parts of a word in Chinese.
struct Unbroken {
    std::string text;
    bool space_before = false;
};

std::vector<Unbroken> units_of(std::string_view line) {
    std::vector<Unbroken> units;
    std::string_view last;
    std::size_t at = 0;
    while (at < line.size()) {
        const std::size_t end = std::min(line.find(' ', at), line.size());
        const std::string_view word = line.substr(at, end - at);
        if (!word.empty()) {
            const std::vector<std::string_view> parts = parts_to_break(word);
            const bool bound = !units.empty() && !breaks_between(last, word);
            if (bound) { units.back().text += " " + std::string(parts.front()); }
            for (std::size_t k = bound ? 1 : 0; k < parts.size(); ++k) {
                units.push_back({std::string(parts[k]), k == 0});
            }
            last = word;
        }
        at = end + 1;
    }
    return units;
}

/// Width of a line whose part before `text` has the width `before`. The sum runs from the left, so that a
/// line that grows has the same width as one that is measured at once.
float width_behind(float before, const ImFont& font, std::string_view text) {
    const auto advance = [&](char32_t c) {
        const bool drawn = c <= IM_UNICODE_CODEPOINT_MAX;  // ImGui draws a box for others
        before +=
            font.GetCharAdvance(drawn ? static_cast<ImWchar>(c) : ImWchar{IM_UNICODE_CODEPOINT_INVALID});
    };
    if (std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80; })) {
        for (const char c : text) { advance(static_cast<unsigned char>(c)); }
    } else {
        for (const char32_t c : from_utf8(text)) { advance(c); }
    }
    return before;
}

/// The longest beginning of `text` that is no wider than `width`, at least one character.
std::size_t bytes_that_fit(const ImFont& font, std::string_view text, float width) {
    std::size_t fits = 0;
    float so_far = 0.0F;
    while (fits < text.size()) {
        const std::size_t next = std::min(
            text.size(), fits + std::max<std::size_t>(1, bytes_of(static_cast<unsigned char>(text[fits]))));
        so_far = width_behind(so_far, font, text.substr(fits, next - fits));
        if (fits > 0 && so_far > width) { break; }
        fits = next;
    }
    return fits;
}

/// Wraps one paragraph, greedily.
void wrap_into(std::vector<std::string>& lines, const ImFont& font, std::string_view paragraph, float width) {
    std::string line;
    float so_far = 0.0F;
    for (auto& [unit, space_before] : units_of(paragraph)) {
        const std::string added = (!line.empty() && space_before ? " " : "") + unit;
        const float longer = width_behind(so_far, font, added);
        if (longer <= width) {
            line += added;
            so_far = longer;
            continue;
        }
        if (!line.empty()) { lines.push_back(line); }
        while (text_width(font, unit) > width && unit.size() > 1) {
            std::size_t cut = bytes_that_fit(font, unit, width);
            // words that should stay together are separated before one of them is broken
            const std::size_t space = unit.rfind(' ', cut);
            if (space != std::string::npos && space > 0) { cut = space; }
            if (cut >= unit.size()) { break; }
            lines.push_back(unit.substr(0, cut));
            unit.erase(0, cut + (unit[cut] == ' ' ? 1 : 0));
        }
        line = unit;
        so_far = text_width(font, unit);
    }
    if (!line.empty()) { lines.push_back(line); }
}

std::string trimmed(std::string text) {
    const auto first = text.find_first_not_of(" \n");
    if (first == std::string::npos) { return {}; }
    return text.substr(first, text.find_last_not_of(" \n") - first + 1);
}

}  // namespace

float text_width(const ImFont& font, std::string_view text) { return width_behind(0.0F, font, text); }

std::string typeset(std::string_view text) {
    constexpr std::array<std::pair<char, const char*>, 6> subscripts{
        {{'i', "ᵢ"}, {'j', "ⱼ"}, {'0', "₀"}, {'1', "₁"}, {'2', "₂"}, {'3', "₃"}}};
    std::string set;
    bool in_formula = false;
    for (std::size_t k = 0; k < text.size(); ++k) {
        const auto found = std::ranges::find_if(subscripts, [&](const auto& subscript) {
            const bool ends = k + 2 >= text.size() || !is_word(text[k + 2]);
            return text[k] == '_' && k + 1 < text.size() && text[k + 1] == subscript.first && ends;
        });
        // two dollar signs open or close one formula
        const bool mark =
            text[k] == '$' && (k == 0 || text[k - 1] != '\\') && (k + 1 == text.size() || text[k + 1] != '$');
        in_formula = in_formula != mark;
        if (in_formula) {
            set += text[k];
            continue;
        }
        // only after a single letter: s_i, but not file_1
        const bool single = k >= 1 && (k == 1 || !is_word(text[k - 2]) || !is_word(text[k - 1]));
        if (found != subscripts.end() && single) {
            set += found->second;
            ++k;
        } else if (text.substr(k, 3) == " - ") {
            set += " –";
            ++k;
        } else {
            set += text[k];
        }
    }
    return set;
}

std::string run_on(std::string_view text) {
    std::string joined;
    for (std::size_t k = 0; k < text.size(); ++k) {
        const bool paragraph = text[k] == '\n' && k + 1 < text.size() && text[k + 1] == '\n';
        joined += text[k] == '\n' && !paragraph ? ' ' : text[k];
        if (paragraph) {
            while (k + 1 < text.size() && text[k + 1] == '\n') { ++k; }
        }
    }
    return trimmed(joined);
}

std::string with_minus_signs(std::string_view text) {
    std::string set;
    for (std::size_t k = 0; k < text.size(); ++k) {
        if (text[k] == '-' && is_minus(text, k)) {
            set += "−";
        } else {
            set += text[k];
        }
    }
    return set;
}

std::vector<std::string> wrapped(const ImFont& font, std::string_view text, float width) {
    std::vector<std::string> lines;
    const std::string set = with_minus_signs(text);
    std::string_view rest = set;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        wrap_into(lines, font, rest.substr(0, end), width);
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return lines;
}

std::string shortened(const ImFont& font, std::string_view text, float width) {
    const std::string set = with_minus_signs(text);
    if (text_width(font, set) <= width) { return set; }
    const float room = width - text_width(font, "…");
    std::string_view kept = std::string_view(set).substr(0, bytes_that_fit(font, set, room));
    while (!kept.empty() && kept.back() == ' ') { kept.remove_suffix(1); }
    return std::string(kept) + "…";
}

std::string shortened_name(const ImFont& font, std::string_view name, float width) {
    if (name.empty() || text_width(font, name) <= width) { return std::string(name); }
    std::size_t last = name.size() - 1;
    while (last > 0 && (static_cast<unsigned char>(name[last]) & 0xC0U) == 0x80U) { --last; }
    const std::string_view end = name.substr(last);
    const float room = width - text_width(font, "…") - text_width(font, end);
    if (room <= 0.0F) { return shortened(font, name, width); }
    return std::string(name.substr(0, bytes_that_fit(font, name, room))) + "…" + std::string(end);
}

std::vector<std::size_t> sentence_ends(std::string_view text) {
    std::vector<std::size_t> ends;
    bool in_formula = false;
    for (std::size_t k = 1; k < text.size(); ++k) {
        if (text[k - 1] == '$' && (k < 2 || text[k - 2] != '\\')) { in_formula = !in_formula; }
        const char c = text[k - 1];
        const bool latin = (c == '.' || c == '?' || c == '!') && (text[k] == ' ' || text[k] == '\n');
        const std::string_view behind = text.substr(0, k);
        const bool chinese = behind.ends_with("。") || behind.ends_with("？") || behind.ends_with("！");
        if (!in_formula && (latin || chinese)) { ends.push_back(k); }
    }
    std::ranges::reverse(ends);
    return ends;
}

std::vector<std::string> wrapped_to(
    const ImFont& font, std::string_view text, float width, std::size_t most_lines) {
    std::vector<std::string> lines = wrapped(font, text, width);
    if (lines.size() <= most_lines) { return lines; }
    if (most_lines == 0) { return {}; }
    for (const std::size_t end : sentence_ends(text)) {
        std::vector<std::string> fewer = wrapped(font, std::string(text.substr(0, end)) + " …", width);
        if (fewer.size() <= most_lines) { return fewer; }
    }
    lines.resize(most_lines);
    lines.back() = shortened(font, lines.back() + "…", width);
    return lines;
}

}  // namespace jw::panels
