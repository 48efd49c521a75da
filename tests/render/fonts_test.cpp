#include <catch2/catch.hpp>

#include <cstdlib>
#include <fstream>
#include <set>

#include <imgui.h>

#include "render/fonts/fonts.hpp"
#include "render/fonts/math_alphabets.hpp"
#include "tests/render/support.hpp"

namespace jw::render::test {
namespace {

struct ImguiContext {
    ImguiContext() {
        ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr;
    }
    ImguiContext(const ImguiContext&) = delete;
    ImguiContext& operator=(const ImguiContext&) = delete;
    ~ImguiContext() { ImGui::DestroyContext(); }
};

std::u32string missing_from(const ImFont& font, std::u32string_view needed) {
    std::u32string missing;
    for (const char32_t c : needed) {
        if (font.FindGlyphNoFallback(static_cast<ImWchar>(c)) == nullptr) { missing += c; }
    }
    return missing;
}

constexpr std::u32string_view kLatin = U"abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
constexpr std::u32string_view kGreek = U"αβγδεζηθικλμνξοπρστυφχψωΓΔΘΛΞΠΣΦΨΩϕϑϵ";

}  // namespace

TEST_CASE("formula fonts hold every letter in every style, and the signs of the book", "[render][fonts]") {
    const ImguiContext context;
    const Fonts fonts = load_fonts(GENERATE(1.0F, 1.5F));
    for (const ImFont* font :
         {fonts.formula, fonts.formula_script, fonts.formula_large, fonts.formula_large_script}) {
        CHECK(
            to_utf8(missing_from(*font, U" 0123456789+-=()[]{}<>.,:;/|′″≡×·−∂‖∥∈≤≥≈≠⁰ᵀ¹²³˜˙¨→⇒√∑∞±∓°⊥⋅")) ==
            "");
        for (const char32_t letter : std::u32string(kLatin) + std::u32string(kGreek)) {
            CAPTURE(to_utf8(std::u32string(1, letter)));
            CHECK(missing_from(
                      *font, std::u32string{math_italic(letter), math_bold(letter), math_bold_italic(letter)})
                      .empty());
        }
        CHECK(missing_from(*font, kLatin).empty());
        CHECK(missing_from(*font, U"ΦθωΔΣ").empty());
    }
}

TEST_CASE(
    "interface fonts hold other characters where they are asked for, and show a box for no glyph",
    "[render][fonts]") {
    const ImguiContext context;
    constexpr std::u32string_view chinese = U"剛體拘束，。「」！";
    for (const ImFont* font : {load_fonts(1.0F).normal}) { CHECK(missing_from(*font, chinese) == chinese); }
    const Fonts fonts = load_fonts(GENERATE(1.0F, 1.25F, 1.5F), std::u32string(chinese) + U'\U0001F600');
    for (const ImFont* font : {fonts.small, fonts.normal, fonts.bold, fonts.title, fonts.mono}) {
        CHECK(to_utf8(missing_from(*font, chinese)) == "");
        CHECK(font->FallbackChar == 0xFFFD);
        const ImFontGlyph* const letter = font->FindGlyph(static_cast<ImWchar>(U'剛'));
        // within its line, as wide as it is high
        CHECK(letter->Y0 >= -1.0F);
        CHECK(letter->Y1 <= font->FontSize + 1.0F);
        CHECK(letter->AdvanceX > 0.7F * font->FontSize);
    }
    CHECK(characters_without_glyph(U"a剛Φ\U0001F600") == U"\U0001F600");
    CHECK(package_of_missing_chinese().empty());
}

TEST_CASE("interface fonts hold what panels write", "[render][fonts]") {
    const ImguiContext context;
    const Fonts fonts = load_fonts(1.0F);
    CHECK(ImGui::GetIO().FontDefault == fonts.normal);
    for (const ImFont* font : {fonts.small, fonts.normal, fonts.bold, fonts.title, fonts.mono}) {
        CHECK(
            to_utf8(missing_from(
                *font, U" Äöüßéñ–—‘’“”…•′″ΦθωσαΔ₀₁₂₉ᵢⱼₓ⁰¹²³ᵀ⁻≤≥≈≠≡±×·−∂∈‖→⇒√∑∞⊥▲▶●■□✓✗│─█")) == "");
        CHECK(missing_from(*font, kLatin).empty());
    }
}

TEST_CASE("letters of different styles have different code points within 16 bits", "[render][fonts]") {
    std::set<char32_t> seen;
    const auto glyphs = math_glyphs();
    for (const MathGlyph& glyph : glyphs) {
        CHECK(glyph.code_point >= 0xE000);
        CHECK(glyph.code_point <= 0xF8FF);
        CHECK(glyph.unicode > 0xFF);
        seen.insert(glyph.code_point);
    }
    CHECK(seen.size() == glyphs.size());
    CHECK(math_italic(U'=') == U'=');
    CHECK(math_italic(U'7') == U'7');
    CHECK(math_bold(U'7') != U'7');
}

TEST_CASE(
    "an italic letter is wider or narrower than the roman one, glyphs stand on one baseline",
    "[render][fonts]") {
    const ImguiContext context;
    const Fonts fonts = load_fonts(1.0F);
    const auto glyph = [&](char32_t c) { return *fonts.formula_large->FindGlyph(static_cast<ImWchar>(c)); };
    CHECK(glyph(math_bold(U's')).AdvanceX > glyph(U's').AdvanceX);
    CHECK(glyph(math_italic(U'x')).AdvanceX > glyph(U'x').AdvanceX);
    // bottoms: 1 px of hinting and the empty border
    CHECK(glyph(math_bold(U'A')).Y1 == Approx(glyph(U'x').Y1).margin(1.0));
    CHECK(glyph(U'x').Y1 == Approx(std::round(fonts.formula_large->Ascent)).margin(2.0));
}

TEST_CASE("UTF-8 of one, two, three and four bytes", "[render][fonts]") {
    CHECK(to_utf8(U"aΦ≡𝚽") == "aΦ≡𝚽");
    CHECK(to_utf8(U"").empty());
}

TEST_CASE("a file that is no font is named, and the letters that are there stay", "[render][fonts]") {
    const ImguiContext context;
    const Fonts fonts = load_fonts(1.0F);
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "DejaVuSans.ttf") << "not a font";
    ::setenv("JOINTWISE_FONTS", folder.path().c_str(), 1);
    CHECK_THROWS_WITH(
        load_fonts(1.5F),
        "font '" + (folder.path() / "DejaVuSans.ttf").string() +
            "' is damaged: it is not a TrueType or OpenType font; replace the file, or take "
            "its folder out of JOINTWISE_FONTS");
    ::unsetenv("JOINTWISE_FONTS");
    CHECK(missing_from(*fonts.normal, kLatin).empty());
    CHECK(ImGui::GetIO().Fonts->IsBuilt());
}

TEST_CASE(
    "letters of phones and of large text fit into textures that graphics of phones take", "[render][fonts]") {
    const ImguiContext context;
    // a page of 390 pixels at a density of 3: 1170/480, in eighths; and the largest letters of a window
    load_fonts(2.375F, {}, AtlasSize::small);
    CHECK(ImGui::GetIO().Fonts->TexWidth <= 4096);
    CHECK(ImGui::GetIO().Fonts->TexHeight <= 4096);
    load_fonts(3.0F, {}, AtlasSize::small);
    CHECK(ImGui::GetIO().Fonts->TexWidth <= 8192);
    CHECK(ImGui::GetIO().Fonts->TexHeight <= 8192);
}

}  // namespace jw::render::test
