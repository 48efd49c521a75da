#include "app/panels/parts/canvas.hpp"

#include <array>
#include <cmath>

#include <imgui.h>

#include "app/panels/parts/text_lines.hpp"
#include "app/session/wording/text_width.hpp"

namespace jw::panels {

namespace {

ImU32 packed_as_it_is(const Colour& colour) {
    return ImGui::ColorConvertFloat4ToU32({colour.r, colour.g, colour.b, colour.a});
}

ImVec2 vec(Point p) { return {p.x, p.y}; }

ImVec2 corner(const Box& box) { return {box.x, box.y}; }
ImVec2 far_corner(const Box& box) { return {box.right(), box.bottom()}; }

}  // namespace

Canvas Canvas::pointed(const Emphasis& lit, std::vector<HotSpot>& spots) const {
    Canvas canvas = *this;
    canvas.lit_ = &lit;
    canvas.spots_ = &spots;
    return canvas;
}

Canvas Canvas::in(render::Tone tone) const {
    Canvas canvas = *this;
    canvas.tone_ = tone;
    canvas.last_packed_ = 0;
    return canvas;
}

Canvas Canvas::within(const Box& box) const {
    Canvas canvas = *this;
    canvas.seen_ = box;
    return canvas;
}

Canvas Canvas::naming(const std::vector<SymbolView>& symbols) const {
    Canvas canvas = *this;
    canvas.symbols_ = &symbols;
    return canvas;
}

Pointable Canvas::symbol(std::string_view scope, std::string_view source) const {
    const int index = symbols_ == nullptr ? -1 : index_of_symbol(*symbols_, scope, source);
    return index < 0 ? Pointable() : Pointable::symbol(index);
}

unsigned Canvas::packed(const Colour& colour) const {
    if (tone_ == render::Tone::light) { return packed_as_it_is(colour); }
    if (last_packed_ == 0 || !(last_ == colour)) {
        last_ = colour;
        last_packed_ = packed_as_it_is(render::toned(colour, tone_));
    }
    return last_packed_;
}

void Canvas::spot(const Box& box, const Pointable& link) const {
    if (spots_ == nullptr || list_ == nullptr || !link) { return; }
    const Box seen = seen_ ? common(box, *seen_) : box;
    if (seen.width > 0.0F && seen.height > 0.0F) { spots_->push_back({seen, link}); }
}

float Canvas::px(float at_720) const { return std::round(at_720 * fonts_->scale); }

float Canvas::line_height(const ImFont* font) const { return std::round(1.16F * font->FontSize); }

float Canvas::text_width(const ImFont* font, std::string_view text) const {
    return panels::text_width(*font, text);
}

void Canvas::text(Point at, const ImFont* font, Colour colour, std::string_view text, Align align) const {
    if (!draws() || text.empty()) { return; }
    const std::string set = with_minus_signs(text);
    if (align != Align::left) { at.x -= (align == Align::right ? 1.0F : 0.5F) * text_width(font, set); }
    const ImVec2 whole{std::round(at.x), std::round(at.y)};
    if (strokes_ != nullptr) { return stroke_text({whole.x, whole.y}, *font, colour, set); }
    list_->AddText(font, font->FontSize, whole, packed(colour), set.data(), set.data() + set.size());
}

void Canvas::stroke_text(Point at, const ImFont& font, const Colour& colour, std::string_view text) const {
    const float baseline = at.y + std::round(font.Ascent);
    for (const char32_t character : from_utf8(text)) {
        const ImFontGlyph* const glyph = font.FindGlyph(static_cast<ImWchar>(character));
        if (glyph == nullptr) { continue; }
        if (glyph->Visible != 0) {
            strokes_->letter({at.x, baseline}, font, character, render::toned(colour, tone_), 1.0F);
        }
        at.x += glyph->AdvanceX;
    }
}

void Canvas::stroke_glyph(Point origin, const ImFontGlyph& glyph, const Colour& colour, float stretch) const {
    for (const ImFont* const font :
         {fonts_->formula, fonts_->formula_script, fonts_->formula_words, fonts_->formula_words_script,
          fonts_->formula_large, fonts_->formula_large_script}) {
        if (&glyph < font->Glyphs.begin() || &glyph >= font->Glyphs.end() || glyph.Visible == 0) { continue; }
        const float baseline = origin.y + stretch * std::round(font->Ascent);
        strokes_->letter({origin.x, baseline}, *font, glyph.Codepoint, render::toned(colour, tone_), stretch);
        return;
    }
}

void Canvas::glyph(Point origin, const ImFontGlyph& glyph, Colour colour, float stretch) const {
    if (strokes_ != nullptr) { return stroke_glyph(origin, glyph, colour, stretch); }
    if (list_ == nullptr || glyph.Visible == 0) { return; }
    list_->PrimReserve(6, 4);
    list_->PrimRectUV(
        {origin.x + glyph.X0, origin.y + stretch * glyph.Y0},
        {origin.x + glyph.X1, origin.y + stretch * glyph.Y1}, {glyph.U0, glyph.V0}, {glyph.U1, glyph.V1},
        packed(colour));
}

void Canvas::fill(const Box& box, Colour colour, float rounding) const {
    if (strokes_ != nullptr) { return strokes_->fill(box, render::toned(colour, tone_), rounding); }
    if (list_ != nullptr) { list_->AddRectFilled(corner(box), far_corner(box), packed(colour), rounding); }
}

void Canvas::outline(const Box& box, Colour colour, float thickness, float rounding) const {
    if (strokes_ != nullptr) {
        return strokes_->outline(box, render::toned(colour, tone_), thickness, rounding);
    }
    if (list_ != nullptr) {
        list_->AddRect(corner(box), far_corner(box), packed(colour), rounding, 0, thickness);
    }
}

void Canvas::line(Point from, Point to, Colour colour, float thickness) const {
    if (strokes_ != nullptr) { return strokes_->line(from, to, render::toned(colour, tone_), thickness); }
    if (list_ != nullptr) { list_->AddLine(vec(from), vec(to), packed(colour), thickness); }
}

void Canvas::dashed_line(Point from, Point to, Colour colour, float thickness) const {
    const float length = std::hypot(to.x - from.x, to.y - from.y);
    if (!draws() || length <= 0.0F) { return; }
    const float dash = px(5.0F);
    const Point unit{(to.x - from.x) / length, (to.y - from.y) / length};
    for (float at = 0.0F; at < length; at += 2.0F * dash) {
        const float end = std::min(at + dash, length);
        line(
            {from.x + at * unit.x, from.y + at * unit.y}, {from.x + end * unit.x, from.y + end * unit.y},
            colour, thickness);
    }
}

void Canvas::disc(Point centre, float radius, Colour colour) const {
    if (strokes_ != nullptr) { return strokes_->disc(centre, radius, render::toned(colour, tone_)); }
    if (list_ != nullptr) { list_->AddCircleFilled(vec(centre), radius, packed(colour)); }
}

void Canvas::ring(Point centre, float radius, Colour colour, float thickness) const {
    if (strokes_ != nullptr) {
        return strokes_->ring(centre, radius, render::toned(colour, tone_), thickness);
    }
    if (list_ != nullptr) { list_->AddCircle(vec(centre), radius, packed(colour), 0, thickness); }
}

void Canvas::hatch(const Box& box, Colour colour, float distance) const {
    for (float at = distance; at < box.width + box.height; at += distance) {
        const float down = std::min(at, box.height);
        const float along = std::min(at, box.width);
        line({box.x + at - down, box.y + down}, {box.x + along, box.y + at - along}, colour, 1.0F);
    }
}

void Canvas::square(Point centre, float side, Colour colour, bool filled) const {
    const Box box{std::round(centre.x - 0.5F * side), std::round(centre.y - 0.5F * side), side, side};
    if (filled) {
        fill(box, colour);
    } else {
        outline(box, colour, std::max(1.0F, px(1.4F)));
    }
}

void Canvas::gradient_mesh(
    std::span<const Point> corners, std::span<const Colour> colours,
    std::span<const unsigned short> triangles) const {
    if (strokes_ != nullptr) {
        for (std::size_t k = 0; k + 2 < triangles.size(); k += 3) {
            const auto [a, b, c] = std::array{triangles[k], triangles[k + 1], triangles[k + 2]};
            strokes_->triangle(
                {corners[a], corners[b], corners[c]},
                {render::toned(colours[a], tone_), render::toned(colours[b], tone_),
                 render::toned(colours[c], tone_)});
        }
        return;
    }
    if (list_ == nullptr) { return; }
    list_->PrimReserve(static_cast<int>(triangles.size()), static_cast<int>(corners.size()));
    // read after PrimReserve, which may restart the count
    const unsigned first = list_->_VtxCurrentIdx;
    for (const unsigned short corner : triangles) {
        list_->PrimWriteIdx(static_cast<ImDrawIdx>(first + corner));
    }
    for (std::size_t k = 0; k < corners.size(); ++k) {
        list_->PrimWriteVtx(vec(corners[k]), ImGui::GetFontTexUvWhitePixel(), packed(colours[k]));
    }
}

}  // namespace jw::panels
