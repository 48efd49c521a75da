#include "app/host/frames/vector_strokes.hpp"

namespace jw::host {

namespace {

using Place = render::VectorPicture::Point;

Place place(panels::Point p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }
Place corner(const panels::Box& box) { return {static_cast<double>(box.x), static_cast<double>(box.y)}; }
double wide(float length) { return static_cast<double>(length); }

}  // namespace

void VectorStrokes::fill(const panels::Box& box, const Colour& colour, float rounding) {
    picture_.fill(corner(box), wide(box.width), wide(box.height), colour, wide(rounding));
}

void VectorStrokes::outline(const panels::Box& box, const Colour& colour, float thickness, float rounding) {
    // like ImGui, which draws the outline half a pixel inside
    const panels::Box inside{box.x + 0.5F, box.y + 0.5F, box.width - 1.0F, box.height - 1.0F};
    picture_.outline(
        corner(inside), wide(inside.width), wide(inside.height), colour, wide(thickness), wide(rounding));
}

void VectorStrokes::line(panels::Point from, panels::Point to, const Colour& colour, float thickness) {
    // like ImGui, which draws lines through the centres of pixels
    const Place a = place({from.x + 0.5F, from.y + 0.5F});
    const Place b = place({to.x + 0.5F, to.y + 0.5F});
    picture_.line(a, b, colour, wide(thickness));
}

void VectorStrokes::disc(panels::Point centre, float radius, const Colour& colour) {
    picture_.disc(place(centre), wide(radius), colour);
}

void VectorStrokes::ring(panels::Point centre, float radius, const Colour& colour, float thickness) {
    // like ImGui: the outer edge of a ring one pixel wide is at the radius
    picture_.ring(place(centre), wide(radius - 0.5F), colour, wide(thickness));
}

void VectorStrokes::triangle(
    const std::array<panels::Point, 3>& corners, const std::array<Colour, 3>& colours) {
    picture_.triangle({place(corners[0]), place(corners[1]), place(corners[2])}, colours);
}

void VectorStrokes::letter(
    panels::Point pen, const ImFont& font, char32_t character, const Colour& colour, float stretch) {
    const render::LetterSource source = letters_.of(font, character);
    picture_.letter(place(pen), source.file, source.unicode, source.pixels_per_em, colour, wide(stretch));
}

}  // namespace jw::host
