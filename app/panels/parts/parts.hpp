#pragma once

#include <string>
#include <string_view>

#include "app/panels/parts/canvas.hpp"

/// Pieces that several panels are made of. Those that return a height took it from the top of their box.
namespace jw::panels {

/// Room that a panel takes; what is needed least is left out first. Bare is for a picture alone that has no
/// room for what is tight: in a window it scrolls.
enum class Density { roomy, compact, tight, bare };

/// Bold title at the left, soft note at the right, a hairline below.
float heading(const Canvas& canvas, const Box& box, std::string_view title, std::string_view note = {});

/// Draws a heading with a formula before the title: "\\boldsymbol{\\Phi}_q".
float heading(
    const Canvas& canvas, const Box& box, std::string_view symbol, std::string_view title,
    std::string_view note);
float heading_height(const Canvas& canvas);

/// Sheet with round corners over something else.
void sheet(const Canvas& canvas, const Box& box, Colour shade, Colour edge);

/// Width of the thinnest line.
float hairline(const Canvas& canvas);

/// Wrapped text with formulas; whole sentences are left out where more than `most_lines` would be needed.
float paragraph(
    const Canvas& canvas, const Box& box, const ImFont* font, Colour colour, std::string_view text,
    std::size_t most_lines = 100);

/// What a paragraph needs to be whole.
float paragraph_height(const Canvas& canvas, const ImFont* font, std::string_view text, float width);

/// Value of an equation as text: "0.0123", "-1.2e-07", and "0" for rounding.
std::string live_text(double value);

/// Fewer decimals from 100 on, so that a column of numbers holds any of them and the point rarely moves.
std::string column_text(double value, int decimals);

}  // namespace jw::panels
