#pragma once

#include <array>

#include "app/panels/parts/box.hpp"
#include "render/scene/palette.hpp"

struct ImFont;

namespace jw::panels {

/// Receives shapes that a canvas draws instead of pixels, for pictures that stay sharp at any size. Lengths
/// in pixels of the frame, y down; later shapes are over earlier ones.
class Strokes {
public:
    using Colour = render::Colour;

    virtual ~Strokes() = default;
    virtual void fill(const Box& box, const Colour& colour, float rounding) = 0;
    virtual void outline(const Box& box, const Colour& colour, float thickness, float rounding) = 0;
    virtual void line(Point from, Point to, const Colour& colour, float thickness) = 0;
    virtual void disc(Point centre, float radius, const Colour& colour) = 0;
    virtual void ring(Point centre, float radius, const Colour& colour, float thickness) = 0;
    virtual void triangle(const std::array<Point, 3>& corners, const std::array<Colour, 3>& colours) = 0;
    /// @param pen  start of the letter on its baseline
    /// @param character  in the numbering of `font`: letters of formulas have private numbers
    /// @param stretch  in height, about the baseline
    virtual void letter(
        Point pen, const ImFont& font, char32_t character, const Colour& colour, float stretch) = 0;
};

}  // namespace jw::panels
