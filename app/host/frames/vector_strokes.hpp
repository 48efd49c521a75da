#pragma once

#include "app/panels/parts/canvas.hpp"
#include "render/files/vector_picture.hpp"
#include "render/fonts/fonts.hpp"

namespace jw::host {

/// Shapes of a canvas, drawn into a vector picture with the fonts that the canvas measures with.
class VectorStrokes : public panels::Strokes {
public:
    /// Both must outlive this. @throws std::runtime_error if a font is missing
    VectorStrokes(render::VectorPicture& picture, const render::Fonts& fonts)
        : picture_(picture), letters_(fonts) {}

    void fill(const panels::Box& box, const Colour& colour, float rounding) override {
        picture_.fill(place({box.x, box.y}), box.width, box.height, colour, rounding);
    }
    void outline(const panels::Box& box, const Colour& colour, float thickness, float rounding) override {
        // like ImGui, which draws the outline half a pixel inside
        const panels::Box inside{box.x + 0.5F, box.y + 0.5F, box.width - 1.0F, box.height - 1.0F};
        picture_.outline(
            place({inside.x, inside.y}), inside.width, inside.height, colour, thickness, rounding);
    }
    void line(panels::Point from, panels::Point to, const Colour& colour, float thickness) override {
        // like ImGui, which draws lines through the centres of pixels
        picture_.line(
            place({from.x + 0.5F, from.y + 0.5F}), place({to.x + 0.5F, to.y + 0.5F}), colour, thickness);
    }
    void disc(panels::Point centre, float radius, const Colour& colour) override {
        picture_.disc(place(centre), radius, colour);
    }
    void ring(panels::Point centre, float radius, const Colour& colour, float thickness) override {
        // like ImGui: the outer edge of a ring one pixel wide is at the radius
        picture_.ring(place(centre), radius - 0.5F, colour, thickness);
    }
    void triangle(
        const std::array<panels::Point, 3>& corners, const std::array<Colour, 3>& colours) override {
        picture_.triangle({place(corners[0]), place(corners[1]), place(corners[2])}, colours);
    }
    void letter(
        panels::Point pen, const ImFont& font, char32_t character, const Colour& colour,
        float stretch) override {
        const render::LetterSource source = letters_.of(font, character);
        picture_.letter(place(pen), source.file, source.unicode, source.pixels_per_em, colour, stretch);
    }

private:
    static render::VectorPicture::Point place(panels::Point p) { return {p.x, p.y}; }

    render::VectorPicture& picture_;
    render::LetterSources letters_;
};

}  // namespace jw::host
