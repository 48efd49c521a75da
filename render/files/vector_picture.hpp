#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "render/files/image.hpp"
#include "render/fonts/font_search.hpp"
#include "render/scene/palette.hpp"

namespace jw::render {

enum class VectorFormat { svg, pdf };

/// A picture of lines, areas and letters as an SVG or PDF file, sharp at any size. Letters of a PDF are
/// searchable text; in an SVG they are outlines. Lengths in pixels of the picture, y down.
class VectorPicture {
public:
    struct Point {
        double x = 0.0;
        double y = 0.0;
    };

    /// @throws std::runtime_error if there is no memory for it
    VectorPicture(VectorFormat format, int width, int height);
    ~VectorPicture();
    VectorPicture(const VectorPicture&) = delete;
    VectorPicture& operator=(const VectorPicture&) = delete;

    void fill(Point corner, double width, double height, const Colour& colour, double rounding = 0.0);
    void outline(
        Point corner, double width, double height, const Colour& colour, double thickness, double rounding);
    void line(Point from, Point to, const Colour& colour, double thickness);
    void disc(Point centre, double radius, const Colour& colour);
    void ring(Point centre, double radius, const Colour& colour, double thickness);
    /// A triangle whose colours are interpolated between the corners.
    void triangle(const std::array<Point, 3>& corners, const std::array<Colour, 3>& colours);
    /// A letter of a font, unhinted. @param pen  its start on the baseline @param stretch  of its height
    void letter(
        Point pen, const FontFile& font, char32_t unicode, double pixels_per_em, const Colour& colour,
        double stretch = 1.0);
    /// A picture of pixels, drawn in a rectangle.
    void image(const Image& image, Point corner, double width, double height);

    /// The file; nothing can be drawn afterwards. @throws std::runtime_error with the message of cairo
    std::vector<std::uint8_t> finish();

private:
    struct Surface;
    std::unique_ptr<Surface> surface_;
};

}  // namespace jw::render
