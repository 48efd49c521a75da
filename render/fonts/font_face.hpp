#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

struct FT_FaceRec_;

/// Glyphs of a font file as pictures, through FreeType.
namespace jw::render {

/// Coverage of one glyph, 0 to 255, top row first, with an empty border of one texel. Distances are in pixels
/// from the pen position on the baseline.
struct GlyphBitmap {
    int columns = 0;  ///< texels; a pixel is as wide as `oversampling` of them
    int rows = 0;
    float left = 0.0F;   ///< distance of the left edge
    float top = 0.0F;    ///< distance of the upper edge, upwards
    float width = 0.0F;  ///< pixels
    float advance = 0.0F;
    std::vector<std::uint8_t> coverage;
};

class FontFace {
public:
    /// @throws std::runtime_error naming `path` and what is wrong: it cannot be read, or is damaged.
    explicit FontFace(const std::filesystem::path& path);
    ~FontFace();
    FontFace(FontFace&&) noexcept;
    FontFace& operator=(FontFace&&) noexcept;

    /// The whole file, for other readers.
    const std::vector<std::uint8_t>& bytes() const { return bytes_; }

    /// Distance from the highest ascender to the lowest descender, which ImGui uses as the size of a font
    /// [em].
    double line_height() const;

    bool has(char32_t character) const;
    /// Number of a character's glyph in the font; 0 if there is none.
    unsigned glyph_index(char32_t character) const;

    /// The face for libraries that draw with FreeType themselves; valid as long as this object exists.
    FT_FaceRec_* freetype() const;

    /// Glyph of `character`; nothing if the font does not have it.
    ///
    /// Hinted to whole pixels vertically, never horizontally.
    /// @param pixels_per_em  size
    /// @param oversampling  texels per pixel across. 1: for text at whole pixels, with rounded advances;
    /// more: for glyphs at any x, filtered so that bilinear sampling shows the true coverage
    std::optional<GlyphBitmap> render(char32_t character, double pixels_per_em, int oversampling);

private:
    struct Library;
    struct Face;
    std::vector<std::uint8_t> bytes_;  // read as long as the face is used
    std::unique_ptr<Library> library_;
    std::unique_ptr<Face> face_;
};

/// Version of FreeType, "2.12.1".
std::string freetype_version();

/// @throws std::runtime_error naming `path` and why it cannot be read, or what is wrong with it
std::vector<std::uint8_t> read_font_file(const std::filesystem::path& path);

/// Fault of a TrueType or OpenType file of one font, such as "it ends too early"; empty if there is none.
/// Every table must lie within the file and have the checksum that the file gives, and all tables that text
/// needs must be there.
/// @source OpenType specification 1.9, "Font file", table directory
std::string fault_of_font(std::span<const std::uint8_t> bytes);

}  // namespace jw::render
