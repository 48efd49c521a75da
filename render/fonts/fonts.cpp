#include "render/fonts/fonts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <new>
#include <optional>
#include <vector>

#include <imgui.h>

#include "render/fonts/font_face.hpp"
#include "render/fonts/font_search.hpp"
#include "render/fonts/math_alphabets.hpp"

namespace jw::render {
namespace {

/// Width of the atlas for letters of a scale. The height follows from it, and is at most 16384.
int atlas_width(float scale, AtlasSize size) {
    if (scale > 6.0F) { return 16384; }
    if (scale > 3.0F) { return 8192; }
    return size == AtlasSize::small && scale > 1.5F ? 4096 : 2048;
}

constexpr char32_t kMissing = 0xFFFD;
constexpr char32_t kBox = 0x25A1;            // □
constexpr char32_t kLastCharacter = 0xFFFF;  // ImGui of Debian counts with 16 bits

// an x of DejaVu at this fraction of the size is as high as an x of Latin Modern
constexpr double kWordsInFormula = 0.8;

// Formula glyphs stand at any x: three texels per pixel make their stems equally wide. Interface text stands
// at whole pixels and is sharpest with one texel.
constexpr int kFormulaOversampling = 3;

/// Characters of the interface: first and last of each run.
constexpr std::array<std::array<char32_t, 2>, 20> kInterface{{
    {0x0021, 0x007E}, {0x00A1, 0x00FF},  // Latin-1; the space comes with the base font
    {0x0100, 0x017F},                    // Latin Extended-A: names in most languages of Europe
    {0x0400, 0x045F},                    // Cyrillic
    {0x02C6, 0x02DC}, {0x0302, 0x0308},  // accents; those of the second run stand over the preceding letter
    {0x0391, 0x03D6}, {0x03F5, 0x03F5},  // Greek
    {0x1D40, 0x1D40}, {0x1D62, 0x1D65},  // ᵀ ᵢ ᵣ
    {0x2010, 0x2026}, {0x2030, 0x203A},  // dashes, quotes, dots, primes
    {0x2070, 0x209C}, {0x2190, 0x21D4},  // super- and subscripts, arrows
    {0x2200, 0x226B}, {0x22A4, 0x22C5},  // operators
    {0x2500, 0x2503}, {0x2580, 0x25CF},  // lines, blocks and marks
    {0x2713, 0x2718}, {0x2C7C, 0x2C7C},  // ✓ ✗ ⱼ
}};

/// Characters of formulas that are the same in every style; letters come from `math_glyphs`.
constexpr std::array<std::array<char32_t, 2>, 16> kFormula{{
    {0x0021, 0x007E},
    {0x00A8, 0x00B9},
    {0x00D7, 0x00D7},
    {0x00F7, 0x00F7},
    {0x02C6, 0x02DC},
    {0x0391, 0x03D6},
    {0x1D40, 0x1D40},
    {0x2013, 0x2026},
    {0x2032, 0x2034},
    {0x2070, 0x209C},
    {0x2190, 0x2193},
    {0x21D2, 0x21D4},
    {0x2200, 0x226B},
    {0x22A4, 0x22C5},
    {0x2308, 0x230B},
    {0x23A1, 0x23A6},
}};

/// Hairlines of Latin Modern are a third of a pixel wide: darkened, they stay visible on a projector.
std::optional<GlyphBitmap> darkened(std::optional<GlyphBitmap> glyph) {
    static const std::array<std::uint8_t, 256> darker = [] {
        constexpr double exponent = 0.78;
        std::array<std::uint8_t, 256> made{};
        for (std::size_t c = 0; c < made.size(); ++c) {
            made[c] = static_cast<std::uint8_t>(
                std::lround(255.0 * std::pow(static_cast<double>(c) / 255.0, exponent)));
        }
        return made;
    }();
    if (glyph) {
        for (std::uint8_t& c : glyph->coverage) { c = darker[c]; }
    }
    return glyph;
}

/// Fills the atlas of a context. ImGui's own rasteriser does not hint and cannot go beyond 16 bits, so it
/// only packs: every glyph but the space is a custom rectangle (`AddCustomRectFontGlyph`) drawn by FreeType.
class AtlasBuilder {
public:
    /// @throws std::runtime_error as `load_fonts`; then the atlas is unchanged
    AtlasBuilder(ImFontAtlas& atlas, float scale, AtlasSize size) : atlas_(atlas) {
        for (const FontFile& file : kFontFiles) { face_of(file); }
        atlas_.Clear();
        atlas_.TexDesiredWidth = atlas_width(scale, size);
        atlas_.Flags |= ImFontAtlasFlags_NoMouseCursors;
    }

    /// @param others  characters beyond those of the interface
    ImFont* add_interface(const FontFile& file, float size, std::u32string_view others) {
        FontFace& face = face_of(file);
        ImFont* const font = add_base(face, size);
        const double em = static_cast<double>(size) / face.line_height();
        for (const auto& [first, last] : kInterface) {
            for (char32_t c = first; c <= last; ++c) { add_glyph(font, c, face.render(c, em, 1)); }
        }
        for (const char32_t c : others) {
            auto glyph = face.render(c, em, 1);
            if (!glyph) { glyph = face_of(kSans).render(c, em, 1); }
            if (!glyph && chinese_) { glyph = chinese_->render(c, em, 1); }
            add_glyph(font, c, std::move(glyph));
        }
        // ImGui shows this glyph for missing characters
        add_glyph(font, kMissing, face_of(kSans).render(kBox, em, 1));
        return font;
    }

    /// Opens the font for Chinese if a character needs it and the font is installed.
    void open_chinese(std::u32string_view others) {
        FontFace& sans = face_of(kSans);
        const bool needed = std::ranges::any_of(others, [&](char32_t c) { return !sans.has(c); });
        if (needed && !path_of_font(kChinese).empty()) { chinese_ = open_font(kChinese); }
    }

    ImFont* add_formula(float size) {
        FontFace& math = face_of(kMath);
        ImFont* const font = add_base(math, size);
        const double em = static_cast<double>(size) / math.line_height();
        for (const auto& [first, last] : kFormula) {
            for (char32_t c = first; c <= last; ++c) {
                auto glyph = math.render(c, em, kFormulaOversampling);
                // ⁰ ᵀ and the like
                if (!glyph) { glyph = face_of(kSans).render(c, kWordsInFormula * em, kFormulaOversampling); }
                add_glyph(font, c, darkened(std::move(glyph)));
            }
        }
        for (const MathGlyph& letter : math_glyphs()) {
            add_glyph(
                font, letter.code_point, darkened(math.render(letter.unicode, em, kFormulaOversampling)));
        }
        return font;
    }

    /// Packs the glyphs, then copies them to their places.
    void build() {
        unsigned char* texels = nullptr;
        int width = 0;
        int height = 0;
        atlas_.GetTexDataAsAlpha8(&texels, &width, &height);
        for (const auto& [font, glyphs] : placed_) {
            for (ImFontGlyph& glyph : font->Glyphs) {
                const auto found = glyphs.find(glyph.Codepoint);
                if (found == glyphs.end()) { continue; }
                copy(found->second, texels, width);
                place(glyph, *font, found->second.bitmap);
            }
        }
    }

private:
    struct Placed {
        int rectangle;
        GlyphBitmap bitmap;
    };

    FontFace& face_of(const FontFile& file) {
        const auto found = faces_.find(file.name);
        return found != faces_.end() ? found->second
                                     : faces_.emplace(file.name, open_font(file)).first->second;
    }

    /// A font that contains only the space. Its face has been checked, because ImGui would stop the program.
    ImFont* add_base(const FontFace& face, float size) {
        static constexpr ImWchar only_space[] = {0x20, 0x20, 0};  // read when the atlas is built
        ImFontConfig config;
        config.OversampleH = 1;
        config.PixelSnapH = true;
        // the atlas frees this copy
        void* const copy = ImGui::MemAlloc(face.bytes().size());
        if (copy == nullptr) { throw std::bad_alloc(); }
        std::memcpy(copy, face.bytes().data(), face.bytes().size());
        const auto bytes = static_cast<int>(face.bytes().size());
        return atlas_.AddFontFromMemoryTTF(copy, bytes, size, &config, only_space);
    }

    void add_glyph(ImFont* font, char32_t code_point, std::optional<GlyphBitmap> glyph) {
        if (!glyph || glyph->columns == 0 || glyph->rows == 0 || placed_[font].contains(code_point)) {
            return;
        }
        if (code_point > kLastCharacter) { return; }
        const int rectangle = atlas_.AddCustomRectFontGlyph(
            font, static_cast<ImWchar>(code_point), glyph->columns, glyph->rows, glyph->advance);
        placed_[font].emplace(code_point, Placed{rectangle, std::move(*glyph)});
    }

    void copy(const Placed& placed, unsigned char* texels, int width) const {
        const ImFontAtlasCustomRect& rectangle = *atlas_.GetCustomRectByIndex(placed.rectangle);
        for (int row = 0; row < placed.bitmap.rows; ++row) {
            std::copy_n(
                placed.bitmap.coverage.begin() + row * placed.bitmap.columns, placed.bitmap.columns,
                texels + (rectangle.Y + row) * width + rectangle.X);
        }
    }

    /// Places a glyph, which ImGui has made as large as its rectangle, at the top of the line.
    static void place(ImFontGlyph& glyph, const ImFont& font, const GlyphBitmap& bitmap) {
        const float baseline = std::round(font.Ascent);
        glyph.X0 = bitmap.left;
        glyph.X1 = bitmap.left + bitmap.width;
        glyph.Y0 = baseline - bitmap.top;
        glyph.Y1 = glyph.Y0 + static_cast<float>(bitmap.rows);
    }

    ImFontAtlas& atlas_;
    std::map<std::string, FontFace> faces_;
    std::optional<FontFace> chinese_;
    std::map<ImFont*, std::map<char32_t, Placed>> placed_;
};

}  // namespace

Fonts load_fonts(float scale, std::u32string_view others, AtlasSize atlas) {
    AtlasBuilder builder(*ImGui::GetIO().Fonts, scale, atlas);
    builder.open_chinese(others);
    const auto size = [scale](float pixels) { return std::round(pixels * scale); };
    Fonts fonts;
    fonts.scale = scale;
    fonts.normal = builder.add_interface(kSans, size(16.0F), others);
    fonts.small = builder.add_interface(kSans, size(14.0F), others);
    fonts.bold = builder.add_interface(kSansBold, size(16.0F), others);
    fonts.title = builder.add_interface(kSansBold, size(23.0F), others);
    fonts.mono = builder.add_interface(kMono, size(14.0F), others);
    fonts.formula = builder.add_formula(size(21.0F));
    fonts.formula_script = builder.add_formula(size(15.0F));
    fonts.formula_words = builder.add_formula(size(17.0F));
    fonts.formula_words_script = builder.add_formula(size(13.0F));
    fonts.formula_large = builder.add_formula(size(30.0F));
    fonts.formula_large_script = builder.add_formula(size(21.0F));
    builder.build();
    ImGui::GetIO().FontDefault = fonts.normal;
    return fonts;
}

struct LetterSources::Faces {
    FontFace sans = open_font(kSans);
    FontFace bold = open_font(kSansBold);
    FontFace mono = open_font(kMono);
    FontFace math = open_font(kMath);
    std::optional<FontFace> chinese;
    std::map<char32_t, char32_t> letters;  ///< of formulas: private number to Unicode
};

LetterSources::LetterSources(const Fonts& fonts) : fonts_(fonts), faces_(std::make_unique<Faces>()) {
    if (!path_of_font(kChinese).empty()) { faces_->chinese = open_font(kChinese); }
    for (const MathGlyph& glyph : math_glyphs()) { faces_->letters[glyph.code_point] = glyph.unicode; }
}

LetterSources::~LetterSources() = default;

LetterSource LetterSources::of(const ImFont& font, char32_t character) const {
    const auto size = static_cast<double>(font.FontSize);
    const Faces& faces = *faces_;
    const bool is_bold = &font == fonts_.bold || &font == fonts_.title;
    const bool is_words = is_bold || &font == fonts_.normal || &font == fonts_.small || &font == fonts_.mono;
    const FontFace& own = is_bold                ? faces.bold
                          : &font == fonts_.mono ? faces.mono
                          : is_words             ? faces.sans
                                                 : faces.math;
    const FontFile file = is_bold ? kSansBold : &font == fonts_.mono ? kMono : is_words ? kSans : kMath;
    const double em = size / own.line_height();
    const auto letter = faces.letters.find(character);
    if (!is_words && letter != faces.letters.end()) { return {file, letter->second, em}; }
    if (own.has(character)) { return {file, character, em}; }
    if (faces.sans.has(character)) { return {kSans, character, is_words ? em : kWordsInFormula * em}; }
    if (faces.chinese && faces.chinese->has(character)) { return {kChinese, character, em}; }
    return {kSans, kBox, em};
}

bool is_of_interface(char32_t character) {
    return character <= U' ' || std::ranges::any_of(kInterface, [&](const auto& run) {
               return run[0] <= character && character <= run[1];
           });
}

std::u32string characters_without_glyph(std::u32string_view characters) {
    const FontFace sans = open_font(kSans);
    std::optional<FontFace> chinese;
    if (!path_of_font(kChinese).empty()) { chinese = open_font(kChinese); }
    std::u32string missing;
    for (const char32_t c : characters) {
        const bool has = c <= U' ' || sans.has(c) || (chinese && chinese->has(c));
        const bool shown = has && c <= kLastCharacter;
        if (!shown && missing.find(c) == std::u32string::npos) { missing += c; }
    }
    return missing;
}

}  // namespace jw::render
