#include "render/fonts/font_face.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <ft2build.h>
#include FT_FREETYPE_H

#include "render/fonts/font_file.hpp"

namespace jw::render {

struct FontFace::Library {
    FT_Library handle = nullptr;

    Library() {
        if (FT_Init_FreeType(&handle) != 0) { throw std::runtime_error("FreeType cannot be started"); }
    }
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
    ~Library() { FT_Done_FreeType(handle); }
};

struct FontFace::Face {
    FT_Face handle = nullptr;

    Face(const Library& library, const std::vector<std::uint8_t>& bytes, const std::filesystem::path& path) {
        const auto size = static_cast<FT_Long>(bytes.size());
        if (FT_New_Memory_Face(library.handle, bytes.data(), size, 0, &handle) != 0) {
            throw std::runtime_error("font '" + path.string() + "' is damaged: FreeType cannot read it");
        }
    }
    Face(const Face&) = delete;
    Face& operator=(const Face&) = delete;
    ~Face() { FT_Done_Face(handle); }
};

namespace {

constexpr double kUnitsPerPixel = 64.0;  // FreeType counts in 26.6 fixed point
constexpr unsigned kPointsPerInch = 72;  // one point is one pixel

constexpr int kBorder = 1;  // empty texels all around, so that neighbours in an atlas do not show through

/// Coverage of a pixel-wide window at every texel, which a screen pixel that starts there must show.
std::vector<std::uint8_t> box_filtered(const FT_Bitmap& bitmap, int window, int columns, int rows) {
    std::vector<std::uint8_t> filtered(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    for (int row = 0; row < static_cast<int>(bitmap.rows); ++row) {
        const unsigned char* const line = bitmap.buffer + row * bitmap.pitch;
        std::uint8_t* const out = &filtered[static_cast<std::size_t>((row + kBorder) * columns + kBorder)];
        for (int column = 0; column < columns - 2 * kBorder; ++column) {
            int sum = window / 2;
            const int last = std::min(column, static_cast<int>(bitmap.width) - 1);
            for (int n = std::max(0, column - window + 1); n <= last; ++n) { sum += line[n]; }
            out[column] = static_cast<std::uint8_t>(sum / window);
        }
    }
    return filtered;
}

}  // namespace

FontFace::FontFace(const std::filesystem::path& path)
    : bytes_(read_font_file(path)),
      library_(std::make_unique<Library>()),
      face_(std::make_unique<Face>(*library_, bytes_, path)) {}

FontFace::~FontFace() {
    face_.reset();  // before its library
}

FontFace::FontFace(FontFace&&) noexcept = default;

FontFace& FontFace::operator=(FontFace&& other) noexcept {
    std::swap(bytes_, other.bytes_);
    std::swap(face_, other.face_);
    std::swap(library_, other.library_);
    return *this;
}

double FontFace::line_height() const {
    const FT_Face face = face_->handle;
    return static_cast<double>(face->ascender - face->descender) / face->units_per_EM;
}

unsigned FontFace::glyph_index(char32_t character) const {
    return FT_Get_Char_Index(face_->handle, static_cast<FT_ULong>(character));
}

FT_FaceRec_* FontFace::freetype() const { return face_->handle; }

bool FontFace::has(char32_t character) const { return FT_Get_Char_Index(face_->handle, character) != 0; }

std::optional<GlyphBitmap> FontFace::render(char32_t character, double pixels_per_em, int oversampling) {
    const FT_Face face = face_->handle;
    const FT_UInt index = FT_Get_Char_Index(face, character);
    if (index == 0) { return std::nullopt; }
    const auto size = static_cast<FT_F26Dot6>(std::lround(pixels_per_em * kUnitsPerPixel));
    const auto texels = static_cast<unsigned>(oversampling);
    FT_Set_Char_Size(face, 0, size, kPointsPerInch * texels, kPointsPerInch);
    if (FT_Load_Glyph(face, index, FT_LOAD_RENDER | FT_LOAD_TARGET_LIGHT) != 0) { return std::nullopt; }

    const FT_GlyphSlot slot = face->glyph;
    const auto scale = static_cast<float>(oversampling);
    GlyphBitmap glyph;
    const bool blank = slot->bitmap.width == 0 || slot->bitmap.rows == 0;
    glyph.columns = blank ? 0 : static_cast<int>(slot->bitmap.width) + oversampling - 1 + 2 * kBorder;
    glyph.rows = blank ? 0 : static_cast<int>(slot->bitmap.rows) + 2 * kBorder;
    // the window of the filter is centred on its texel
    glyph.left = (static_cast<float>(slot->bitmap_left - kBorder) - 0.5F * (scale - 1.0F)) / scale;
    glyph.top = static_cast<float>(slot->bitmap_top + kBorder);
    glyph.width = static_cast<float>(glyph.columns) / scale;
    const auto advance =
        static_cast<float>(static_cast<double>(slot->linearHoriAdvance) / 65536.0 / oversampling);
    glyph.advance = oversampling == 1 ? std::round(advance) : advance;
    if (!blank) { glyph.coverage = box_filtered(slot->bitmap, oversampling, glyph.columns, glyph.rows); }
    return glyph;
}

std::string freetype_version() {
    return std::to_string(FREETYPE_MAJOR) + '.' + std::to_string(FREETYPE_MINOR) + '.' +
           std::to_string(FREETYPE_PATCH);
}

}  // namespace jw::render
