#include "render/fonts/font_face.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include <ft2build.h>
#include FT_FREETYPE_H

namespace jw::render {

namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::size_t kHeadSize = 12;
constexpr std::size_t kRecordSize = 16;
// in table 'head': the only number that its checksum does not include
constexpr std::size_t kAdjustment = 8;

constexpr std::array<std::string_view, 5> kNeeded{"cmap", "head", "hhea", "hmtx", "maxp"};
constexpr std::array<std::string_view, 2> kOutlines{"glyf", "CFF "};

/// Big-endian number in the four bytes from `at` on, which must exist.
std::uint32_t number_at(Bytes bytes, std::size_t at) {
    std::uint32_t number = 0;
    for (std::size_t k = 0; k < 4; ++k) { number = number << 8U | bytes[at + k]; }
    return number;
}

std::string_view tag_at(Bytes bytes, std::size_t at) {
    return {reinterpret_cast<const char*>(bytes.data()) + at, 4};
}

/// Sum modulo 2^32 of the table's 32-bit numbers; the last one is padded with zeros.
std::uint32_t checksum(Bytes table) {
    std::uint32_t sum = 0;
    std::size_t k = 0;
    for (; k + 4 <= table.size(); k += 4) { sum += number_at(table, k); }
    std::uint32_t rest = 0;
    for (std::size_t n = 0; n < 4; ++n) { rest = rest << 8U | (k + n < table.size() ? table[k + n] : 0U); }
    return sum + rest;
}

bool is_font(Bytes bytes) {
    if (bytes.size() < kHeadSize) { return false; }
    const std::string_view kind = tag_at(bytes, 0);
    return kind == std::string_view("\0\1\0\0", 4) || kind == "OTTO" || kind == "true";
}

}  // namespace

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

std::string fault_of_font(Bytes bytes) {
    if (!is_font(bytes)) { return "it is not a TrueType or OpenType font"; }
    const std::size_t tables = number_at(bytes, 4) >> 16U;
    if (kHeadSize + kRecordSize * tables > bytes.size()) { return "it ends too early"; }
    std::vector<std::string_view> found;
    for (std::size_t n = 0; n < tables; ++n) {
        const std::size_t record = kHeadSize + kRecordSize * n;
        const std::string_view tag = tag_at(bytes, record);
        const std::uint64_t begin = number_at(bytes, record + 8);
        const std::uint64_t length = number_at(bytes, record + 12);
        if (begin + length > bytes.size()) { return "it ends too early"; }
        const Bytes table = bytes.subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(length));
        std::uint32_t sum = checksum(table);
        if (tag == "head" && length >= kAdjustment + 4) { sum -= number_at(table, kAdjustment); }
        if (sum != number_at(bytes, record + 4)) { return "a checksum is wrong: a part of it was changed"; }
        found.push_back(tag);
    }
    const auto has = [&](std::string_view tag) { return std::ranges::find(found, tag) != found.end(); };
    if (!std::ranges::all_of(kNeeded, has) || !std::ranges::any_of(kOutlines, has)) {
        return "a part of it is missing";
    }
    return {};
}

std::vector<std::uint8_t> read_font_file(const std::filesystem::path& path) {
    errno = 0;
    std::ifstream in(path, std::ios::binary);
    std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(in), {}};
    if (!in) {
        throw std::runtime_error(
            "font '" + path.string() + "' cannot be read: " + std::generic_category().message(errno));
    }
    if (const std::string fault = fault_of_font(bytes); !fault.empty()) {
        throw std::runtime_error("font '" + path.string() + "' is damaged: " + fault);
    }
    return bytes;
}

}  // namespace jw::render
