#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "render/fonts/font_search.hpp"

struct ImFont;

/// Fonts of panels and formulas for the current ImGui context.
namespace jw::render {

/// Sizes for a picture 720 high at scale 1. Interface fonts are DejaVu. Formula fonts are Latin Modern and
/// also have the letters of `math_alphabets.hpp`, so a formula is laid out with one ImFont per size. The
/// baseline of each font is `ImFont::Ascent` below its top.
///
/// Interface text is sharp at whole pixels. Formula glyphs may stand at any x; round y to whole pixels.
struct Fonts {
    ImFont* small = nullptr;   ///< 14 px
    ImFont* normal = nullptr;  ///< 16 px, the default of the context
    ImFont* bold = nullptr;    ///< 16 px
    ImFont* title = nullptr;   ///< 23 px, bold
    ImFont* mono = nullptr;    ///< 14 px

    ImFont* formula = nullptr;         ///< 21 px
    ImFont* formula_script = nullptr;  ///< 15 px, sub- and superscripts of `formula`; beside words in `small`
    // an x of Latin Modern in these sizes is as high as an x of the words beside it
    ImFont* formula_words = nullptr;         ///< 17 px, beside words in `normal`
    ImFont* formula_words_script = nullptr;  ///< 13 px, scripts of both sizes beside words
    ImFont* formula_large = nullptr;         ///< 30 px, the headline of a step
    ImFont* formula_large_script = nullptr;  ///< 21 px

    float scale = 1.0F;
};

/// Size of the texture that contains the letters.
enum class AtlasSize {
    usual,  ///< up to 16384
    small,  ///< 4096 up to 2.4 times the usual letters, 8192 up to three times: fits graphics of phones
};

/// Loads all fonts into the atlas of the current ImGui context, builds it and makes `normal` the default.
///
/// Searched in the folders of JOINTWISE_FONTS (colon-separated), then where Debian's packages put them.
/// @param scale  1 for a picture 720 high, 1.5 for 1080
/// @param others  characters of texts beyond those of the interface; interface fonts get them from DejaVu or
/// from the font for Chinese, which is opened only for them. A character that no font has is shown as a box.
/// @throws std::runtime_error naming the file that is missing or damaged and its Debian package; then the
/// atlas is unchanged.
Fonts load_fonts(float scale, std::u32string_view others = {}, AtlasSize atlas = AtlasSize::usual);

/// Source of a letter in a font of `Fonts`.
struct LetterSource {
    FontFile file;
    char32_t unicode = 0;  ///< in the file; letters of formulas have other numbers in their ImFont
    double pixels_per_em = 0.0;
};
/// Finds the sources of letters for drawing without pixels; the same ones that `load_fonts` uses.
class LetterSources {
public:
    /// @throws std::runtime_error naming a font that is missing or damaged
    explicit LetterSources(const Fonts& fonts);
    ~LetterSources();
    LetterSources(const LetterSources&) = delete;
    LetterSources& operator=(const LetterSources&) = delete;

    /// Source of a letter; that of a box if no font has the character.
    LetterSource of(const ImFont& font, char32_t character) const;

private:
    struct Faces;
    Fonts fonts_;
    std::unique_ptr<Faces> faces_;
};

/// True if the interface fonts always have the character.
bool is_of_interface(char32_t character);

/// The given characters that no font has, each once. The font for Chinese counts if it is installed.
std::u32string characters_without_glyph(std::u32string_view characters);
/// The Debian package of the font for Chinese if the font is missing, otherwise empty.
std::string package_of_missing_chinese();

/// A font file that `load_fonts` needs.
struct FontSource {
    enum class State { right, missing, damaged };
    std::string name;
    std::string package;    ///< of Debian
    bool optional = false;  ///< only texts in Chinese need it
    State state = State::right;
    std::filesystem::path path;  ///< empty if it is missing
    std::string problem;         ///< empty if the file is usable
    std::string remedy;          ///< of a damaged font
};

/// Every font file, searched for where `load_fonts` searches, or only in `folders`.
std::vector<FontSource> find_fonts();
std::vector<FontSource> find_fonts(const std::vector<std::filesystem::path>& folders);

}  // namespace jw::render
