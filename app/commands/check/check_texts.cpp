#include "app/commands/check/check_texts.hpp"

#include <array>
#include <cstdio>

#include "app/panels/parts/characters.hpp"
#include "app/session/wording/text_width.hpp"
#include "lessons/diagnostics/read_text.hpp"
#include "render/fonts/fonts.hpp"

namespace jw {

namespace {

std::string with_number(char32_t c, const std::string& text) {
    // the character as it is written in the text
    for (std::size_t k = 0; k < text.size(); ++k) {
        if ((static_cast<unsigned char>(text[k]) & 0xC0U) == 0x80U) { continue; }
        std::size_t end = k + 1;
        while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) { ++end; }
        const std::string one = text.substr(k, end - k);
        if (from_utf8(one).front() == c) {
            std::array<char, 12> number{};
            std::snprintf(number.data(), number.size(), "U+%04X", static_cast<unsigned>(c));
            return in_quotes(one) + " (" + number.data() + ')';
        }
    }
    return {};
}

}  // namespace

std::vector<Diagnostic> warnings_about_texts(const std::string& file, const std::vector<ReadText>& texts) {
    std::vector<Diagnostic> warnings = missing_translations(file, texts);
    std::string all;
    for (const ReadText& read : texts) {
        all += read.text.own();
        for (const auto& [tag, text] : read.text.translations()) { all += text; }
    }
    const std::u32string missing = render::characters_without_glyph(panels::characters_in(all));
    if (missing.empty()) { return warnings; }
    const std::string package = render::package_of_missing_chinese();
    std::string hint = "a box is shown in place of each; take other characters";
    if (!package.empty()) { hint = "install the Debian package " + package; }
    std::string list;
    constexpr std::size_t most = 8;
    for (std::size_t k = 0; k < missing.size() && k < most; ++k) {
        list += (k == 0 ? "" : ", ") + with_number(missing[k], all);
    }
    if (missing.size() > most) { list += " and " + std::to_string(missing.size() - most) + " more"; }
    warnings.push_back(
        {file, {}, Code::character, "no font has the characters " + list, hint, Severity::warning});
    return warnings;
}

}  // namespace jw
