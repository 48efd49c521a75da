#include "render/fonts/math_alphabets.hpp"

#include <array>
#include <optional>

namespace jw::render {
namespace {

/// A run of letters that Unicode repeats in the same order in every style.
struct Run {
    char32_t first;
    char32_t last;
    char32_t italic;  ///< where the run starts; 0: the style does not exist
    char32_t bold;
    char32_t bold_italic;
};

constexpr std::array kRuns{
    Run{U'A', U'Z', 0x1D434, 0x1D400, 0x1D468}, Run{U'a', U'z', 0x1D44E, 0x1D41A, 0x1D482},
    Run{U'Α', U'Ω', 0x1D6E2, 0x1D6A8, 0x1D71C}, Run{U'α', U'ω', 0x1D6FC, 0x1D6C2, 0x1D736},
    Run{U'ϵ', U'ϵ', 0x1D716, 0x1D6DC, 0x1D750}, Run{U'ϑ', U'ϑ', 0x1D717, 0x1D6DD, 0x1D751},
    Run{U'ϕ', U'ϕ', 0x1D719, 0x1D6DF, 0x1D753}, Run{U'0', U'9', 0, 0x1D7CE, 0},
};

constexpr char32_t kPlanckConstant = 0x210E;  // Unicode has the italic h here, and a gap in the alphabet

// each style has a block of 256 private code points
constexpr char32_t kItalicBlock = 0xE000;
constexpr char32_t kBoldBlock = 0xE100;
constexpr char32_t kBoldItalicBlock = 0xE200;

/// Position in the block of a style.
std::optional<char32_t> slot_of(char32_t letter) {
    char32_t slot = 0;
    for (const Run& run : kRuns) {
        if (letter >= run.first && letter <= run.last) { return slot + (letter - run.first); }
        slot += run.last - run.first + 1;
    }
    return std::nullopt;
}

bool is_digit(char32_t letter) { return letter >= U'0' && letter <= U'9'; }

char32_t styled(char32_t block, char32_t letter) {
    const auto slot = slot_of(letter);
    return slot ? block + *slot : letter;
}

}  // namespace

char32_t math_italic(char32_t letter) { return is_digit(letter) ? letter : styled(kItalicBlock, letter); }

char32_t math_bold(char32_t letter) { return styled(kBoldBlock, letter); }

char32_t math_bold_italic(char32_t letter) {
    return is_digit(letter) ? letter : styled(kBoldItalicBlock, letter);
}

std::vector<MathGlyph> math_glyphs() {
    std::vector<MathGlyph> glyphs;
    for (const Run& run : kRuns) {
        for (char32_t letter = run.first; letter <= run.last; ++letter) {
            const char32_t offset = letter - run.first;
            glyphs.push_back({math_bold(letter), run.bold + offset});
            if (run.italic == 0) { continue; }
            glyphs.push_back({math_italic(letter), letter == U'h' ? kPlanckConstant : run.italic + offset});
            glyphs.push_back({math_bold_italic(letter), run.bold_italic + offset});
        }
    }
    return glyphs;
}

std::string to_utf8(std::u32string_view text) {
    std::string utf8;
    const auto put = [&utf8](char32_t byte) { utf8.push_back(static_cast<char>(byte)); };
    const auto put_six = [&put](char32_t bits) { put(0x80U | (bits & 0x3FU)); };
    for (const char32_t c : text) {
        if (c < 0x80) {
            put(c);
        } else if (c < 0x800) {
            put(0xC0U | (c >> 6U));
            put_six(c);
        } else if (c < 0x10000) {
            put(0xE0U | (c >> 12U));
            put_six(c >> 6U);
            put_six(c);
        } else {
            put(0xF0U | (c >> 18U));
            put_six(c >> 12U);
            put_six(c >> 6U);
            put_six(c);
        }
    }
    return utf8;
}

}  // namespace jw::render
