#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "app/panels/parts/box.hpp"
#include "app/session/picture/pointable.hpp"
#include "app/session/view/symbols.hpp"
#include "render/fonts/fonts.hpp"
#include "render/scene/palette.hpp"

struct ImDrawList;
struct ImFont;
struct ImFontGlyph;

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

using render::Colour;

enum class Align { left, centre, right };

/// A place on the picture that belongs to an object; see pointable.hpp.
struct HotSpot {
    Box box;
    Pointable link;
};

/// Canvas that panels are drawn on: a draw list of ImGui and the fonts.
///
/// Without a list nothing is drawn: a panel on such a canvas returns the height that it needs, from the same
/// code that draws it. Minus signs of numbers are drawn as −.
class Canvas {
public:
    Canvas(ImDrawList* list, const render::Fonts& fonts) : list_(list), fonts_(&fonts) {}
    /// Canvas that draws shapes instead of pixels; `strokes` must outlive it.
    Canvas(Strokes& strokes, const render::Fonts& fonts) : strokes_(&strokes), fonts_(&fonts) {}

    /// Copies a canvas to another draw list.
    Canvas(ImDrawList* list, const Canvas& other) : Canvas(other) {
        list_ = list;
        strokes_ = nullptr;
    }

    /// Canvas with the same fonts that draws nothing.
    Canvas measuring() const { return {static_cast<ImDrawList*>(nullptr), *fonts_}; }

    /// Canvas for a picture whose objects can be pointed at: objects in `lit` are highlighted, and the places
    /// of objects are added to `spots`. Both must outlive the canvas.
    Canvas pointed(const Emphasis& lit, std::vector<HotSpot>& spots) const;
    /// Canvas that draws every colour in its variant for that tone.
    Canvas in(render::Tone tone) const;

    /// Canvas of which only the part in `box` is visible: places outside cannot be pointed at.
    Canvas within(const Box& box) const;

    /// Canvas on which the symbols in that list can be pointed at; the list must outlive the canvas.
    Canvas naming(const std::vector<SymbolView>& symbols) const;
    /// Link of a symbol; none if the symbol is not in the list.
    Pointable symbol(std::string_view scope, std::string_view source) const;

    /// Registers `box` as a place of `link`.
    void spot(const Box& box, const Pointable& link) const;
    bool lit(const Pointable& link) const { return lit_ != nullptr && lit_->contains(link); }

    const render::Fonts& fonts() const { return *fonts_; }
    bool draws() const { return list_ != nullptr || strokes_ != nullptr; }

    /// Whole pixels for a length in a picture 720 high.
    float px(float at_720) const;

    float line_height(const ImFont* font) const;
    float text_width(const ImFont* font, std::string_view text) const;

    /// Draws text. `at.y` is the top of the line, `at.x` its left edge, centre or right edge.
    void text(
        Point at, const ImFont* font, Colour colour, std::string_view text, Align align = Align::left) const;
    /// One glyph at any x, as formulas need it. @param stretch  in height, from `origin` on
    void glyph(Point origin, const ImFontGlyph& glyph, Colour colour, float stretch = 1.0F) const;

    void fill(const Box& box, Colour colour, float rounding = 0.0F) const;
    void outline(const Box& box, Colour colour, float thickness = 1.0F, float rounding = 0.0F) const;
    void line(Point from, Point to, Colour colour, float thickness = 1.0F) const;
    void dashed_line(Point from, Point to, Colour colour, float thickness = 1.0F) const;
    void disc(Point centre, float radius, Colour colour) const;
    void ring(Point centre, float radius, Colour colour, float thickness) const;
    /// Diagonal lines within `box`: a mark that is visible without colours.
    void hatch(const Box& box, Colour colour, float distance) const;
    /// A square, or its outline if not `filled`; about as large as a small letter.
    void square(Point centre, float side, Colour colour, bool filled) const;
    /// Filled triangles with shared corners, which may differ in colour; three indices each.
    void gradient_mesh(
        std::span<const Point> corners, std::span<const Colour> colours,
        std::span<const unsigned short> triangles) const;

private:
    ImDrawList* list_ = nullptr;
    Strokes* strokes_ = nullptr;  ///< only one of list_ and strokes_ is set
    const render::Fonts* fonts_;
    unsigned packed(const Colour& colour) const;
    void stroke_text(Point at, const ImFont& font, const Colour& colour, std::string_view text) const;
    void stroke_glyph(Point origin, const ImFontGlyph& glyph, const Colour& colour, float stretch) const;

    render::Tone tone_ = render::Tone::light;
    mutable Colour last_;  ///< kept, because the same colour is often used several times in a row
    mutable unsigned last_packed_ = 0;
    const Emphasis* lit_ = nullptr;
    std::vector<HotSpot>* spots_ = nullptr;
    std::optional<Box> seen_;
    const std::vector<SymbolView>* symbols_ = nullptr;
};

}  // namespace jw::panels
