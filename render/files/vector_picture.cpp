#include "render/files/vector_picture.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>

#include <cairo-ft.h>
#include <cairo-pdf.h>
#include <cairo-svg.h>

#include "render/fonts/math_alphabets.hpp"

namespace jw::render {

namespace {

constexpr double kQuarter = 0.5 * std::numbers::pi;

const cairo_user_data_key_t kKept{};

cairo_status_t append(void* to, const unsigned char* data, unsigned length) {
    auto& bytes = *static_cast<std::vector<std::uint8_t>*>(to);
    bytes.insert(bytes.end(), data, data + length);
    return CAIRO_STATUS_SUCCESS;
}

[[noreturn]] void fail(cairo_status_t status) {
    throw std::runtime_error(
        std::string("a vector picture cannot be made: ") + cairo_status_to_string(status));
}

}  // namespace

struct VectorPicture::Surface {
    /// A font for cairo, which keeps the face as long as it needs it.
    struct Font {
        std::shared_ptr<FontFace> face;
        cairo_font_face_t* handle = nullptr;
    };

    std::vector<std::uint8_t> bytes;
    std::map<std::string, Font> fonts;
    cairo_surface_t* surface = nullptr;
    cairo_t* cairo = nullptr;

    Surface(VectorFormat format, int width, int height) {
        surface = format == VectorFormat::svg
                      ? cairo_svg_surface_create_for_stream(&append, &bytes, width, height)
                      : cairo_pdf_surface_create_for_stream(&append, &bytes, width, height);
        if (format == VectorFormat::svg) { cairo_svg_surface_set_document_unit(surface, CAIRO_SVG_UNIT_PX); }
        if (format == VectorFormat::pdf) {
            // the same picture gives the same bytes at any time
            cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
        }
        cairo = cairo_create(surface);
    }
    Surface(const Surface&) = delete;
    Surface& operator=(const Surface&) = delete;
    ~Surface() {
        cairo_destroy(cairo);
        cairo_surface_finish(surface);
        cairo_surface_destroy(surface);
        for (auto& [name, font] : fonts) { cairo_font_face_destroy(font.handle); }
    }

    void set(const Colour& colour) const {
        cairo_set_source_rgba(
            cairo, static_cast<double>(colour.r), static_cast<double>(colour.g),
            static_cast<double>(colour.b), static_cast<double>(colour.a));
    }

    void fill(const Colour& colour) const {
        set(colour);
        cairo_fill(cairo);
    }
    void stroke(const Colour& colour, double thickness) const {
        set(colour);
        cairo_set_line_width(cairo, thickness);
        cairo_stroke(cairo);
    }

    void rectangle(Point corner, double width, double height, double rounding) const {
        const double r = std::min({rounding, 0.5 * width, 0.5 * height});
        if (r <= 0.0) {
            cairo_rectangle(cairo, corner.x, corner.y, width, height);
            return;
        }
        cairo_new_sub_path(cairo);
        cairo_arc(cairo, corner.x + width - r, corner.y + r, r, -kQuarter, 0.0);
        cairo_arc(cairo, corner.x + width - r, corner.y + height - r, r, 0.0, kQuarter);
        cairo_arc(cairo, corner.x + r, corner.y + height - r, r, kQuarter, 2.0 * kQuarter);
        cairo_arc(cairo, corner.x + r, corner.y + r, r, 2.0 * kQuarter, 3.0 * kQuarter);
        cairo_close_path(cairo);
    }

    Font& font_of(const FontFile& file) {
        const auto found = fonts.find(file.name);
        if (found != fonts.end()) { return found->second; }
        Font font{std::make_shared<FontFace>(open_font(file)), nullptr};
        font.handle = cairo_ft_font_face_create_for_ft_face(font.face->freetype(), 0);
        auto* const kept = new std::shared_ptr<FontFace>(font.face);  // deleted by cairo
        const auto forget = [](void* face) { delete static_cast<std::shared_ptr<FontFace>*>(face); };
        if (cairo_font_face_set_user_data(font.handle, &kKept, kept, forget) != CAIRO_STATUS_SUCCESS) {
            delete kept;
        }
        return fonts.emplace(file.name, font).first->second;
    }
};

VectorPicture::VectorPicture(VectorFormat format, int width, int height)
    : surface_(std::make_unique<Surface>(format, width, height)) {
    const cairo_status_t status = cairo_status(surface_->cairo);
    if (status != CAIRO_STATUS_SUCCESS) { fail(status); }
}

VectorPicture::~VectorPicture() = default;

void VectorPicture::fill(Point corner, double width, double height, const Colour& colour, double rounding) {
    surface_->rectangle(corner, width, height, rounding);
    surface_->fill(colour);
}

void VectorPicture::outline(
    Point corner, double width, double height, const Colour& colour, double thickness, double rounding) {
    surface_->rectangle(corner, width, height, rounding);
    surface_->stroke(colour, thickness);
}

void VectorPicture::line(Point from, Point to, const Colour& colour, double thickness) {
    cairo_move_to(surface_->cairo, from.x, from.y);
    cairo_line_to(surface_->cairo, to.x, to.y);
    surface_->stroke(colour, thickness);
}

void VectorPicture::disc(Point centre, double radius, const Colour& colour) {
    cairo_arc(surface_->cairo, centre.x, centre.y, radius, 0.0, 4.0 * kQuarter);
    surface_->fill(colour);
}

void VectorPicture::ring(Point centre, double radius, const Colour& colour, double thickness) {
    cairo_new_sub_path(surface_->cairo);
    cairo_arc(surface_->cairo, centre.x, centre.y, radius, 0.0, 4.0 * kQuarter);
    surface_->stroke(colour, thickness);
}

void VectorPicture::triangle(const std::array<Point, 3>& corners, const std::array<Colour, 3>& colours) {
    const bool even = colours[0] == colours[1] && colours[1] == colours[2];
    if (even) {
        cairo_move_to(surface_->cairo, corners[0].x, corners[0].y);
        cairo_line_to(surface_->cairo, corners[1].x, corners[1].y);
        cairo_line_to(surface_->cairo, corners[2].x, corners[2].y);
        cairo_close_path(surface_->cairo);
        return surface_->fill(colours[0]);
    }
    cairo_pattern_t* const mesh = cairo_pattern_create_mesh();
    cairo_mesh_pattern_begin_patch(mesh);
    cairo_mesh_pattern_move_to(mesh, corners[0].x, corners[0].y);
    cairo_mesh_pattern_line_to(mesh, corners[1].x, corners[1].y);
    cairo_mesh_pattern_line_to(mesh, corners[2].x, corners[2].y);
    for (unsigned k = 0; k < 3; ++k) {
        const Colour& c = colours[k];
        cairo_mesh_pattern_set_corner_color_rgba(
            mesh, k, static_cast<double>(c.r), static_cast<double>(c.g), static_cast<double>(c.b),
            static_cast<double>(c.a));
    }
    cairo_mesh_pattern_end_patch(mesh);
    cairo_set_source(surface_->cairo, mesh);
    cairo_paint(surface_->cairo);
    cairo_pattern_destroy(mesh);
}

void VectorPicture::letter(
    Point pen, const FontFile& font, char32_t unicode, double pixels_per_em, const Colour& colour,
    double stretch) {
    Surface::Font& face = surface_->font_of(font);
    surface_->set(colour);
    cairo_set_font_face(surface_->cairo, face.handle);
    cairo_matrix_t size;
    cairo_matrix_init_scale(&size, pixels_per_em, stretch * pixels_per_em);
    cairo_set_font_matrix(surface_->cairo, &size);
    const std::string text = to_utf8(std::u32string(1, unicode));
    const cairo_glyph_t glyph{face.face->glyph_index(unicode), pen.x, pen.y};
    const cairo_text_cluster_t cluster{static_cast<int>(text.size()), 1};
    cairo_show_text_glyphs(
        surface_->cairo, text.data(), static_cast<int>(text.size()), &glyph, 1, &cluster, 1,
        static_cast<cairo_text_cluster_flags_t>(0));
}

void VectorPicture::image(const Image& image, Point corner, double width, double height) {
    cairo_surface_t* const pixels = cairo_image_surface_create(CAIRO_FORMAT_RGB24, image.width, image.height);
    if (const cairo_status_t status = cairo_surface_status(pixels); status != CAIRO_STATUS_SUCCESS) {
        cairo_surface_destroy(pixels);
        fail(status);
    }
    cairo_surface_flush(pixels);
    unsigned char* const data = cairo_image_surface_get_data(pixels);
    const int stride = cairo_image_surface_get_stride(pixels);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const std::uint8_t* const rgb = image.at(x, y);
            unsigned char* const bgr = data + y * stride + 4 * x;
            bgr[0] = rgb[2];
            bgr[1] = rgb[1];
            bgr[2] = rgb[0];
        }
    }
    cairo_surface_mark_dirty(pixels);
    cairo_save(surface_->cairo);
    cairo_translate(surface_->cairo, corner.x, corner.y);
    cairo_scale(surface_->cairo, width / image.width, height / image.height);
    cairo_set_source_surface(surface_->cairo, pixels, 0.0, 0.0);
    cairo_paint(surface_->cairo);
    cairo_restore(surface_->cairo);
    cairo_surface_destroy(pixels);
}

std::vector<std::uint8_t> VectorPicture::finish() {
    cairo_show_page(surface_->cairo);
    cairo_surface_finish(surface_->surface);
    cairo_status_t status = cairo_status(surface_->cairo);
    if (status == CAIRO_STATUS_SUCCESS) { status = cairo_surface_status(surface_->surface); }
    if (status != CAIRO_STATUS_SUCCESS) { fail(status); }
    return surface_->bytes;
}

}  // namespace jw::render
