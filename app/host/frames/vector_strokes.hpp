#pragma once

#include "app/panels/parts/strokes.hpp"
#include "render/files/vector_picture.hpp"
#include "render/fonts/fonts.hpp"

namespace jw::host {

/// Shapes of a canvas, drawn into a vector picture with the fonts that the canvas measures with.
class VectorStrokes : public panels::Strokes {
public:
    /// Both must outlive this. @throws std::runtime_error if a font is missing
    VectorStrokes(render::VectorPicture& picture, const render::Fonts& fonts)
        : picture_(picture), letters_(fonts) {}

    void fill(const panels::Box& box, const Colour& colour, float rounding) override;
    void outline(const panels::Box& box, const Colour& colour, float thickness, float rounding) override;
    void line(panels::Point from, panels::Point to, const Colour& colour, float thickness) override;
    void disc(panels::Point centre, float radius, const Colour& colour) override;
    void ring(panels::Point centre, float radius, const Colour& colour, float thickness) override;
    void triangle(const std::array<panels::Point, 3>& corners, const std::array<Colour, 3>& colours) override;
    void letter(
        panels::Point pen, const ImFont& font, char32_t character, const Colour& colour,
        float stretch) override;

private:
    render::VectorPicture& picture_;
    render::LetterSources letters_;
};

}  // namespace jw::host
