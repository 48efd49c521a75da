#pragma once

#include <string>
#include <string_view>

#include "app/panels/parts/canvas.hpp"

/// Pieces that several panels are made of. If a function returns a height, it has used this height from the
/// top of its box.
namespace jw::panels {

/// Room that a panel takes; the least important parts are left out first. `bare` is only for pictures without
/// room for `tight`: a window scrolls instead.
enum class Density { roomy, compact, tight, bare };

/// The value for a density; `bare` is as `tight`.
template <class T>
T at_density(Density density, T roomy, T compact, T tight) {
    return density == Density::roomy ? roomy : (density == Density::compact ? compact : tight);
}

/// Draws a bold title at the left, a pale note at the right, and a thin line below.
float heading(const Canvas& canvas, const Box& box, std::string_view title, std::string_view note = {});

/// Draws a heading with a formula before the title: "\\boldsymbol{\\Phi}_q".
float heading(
    const Canvas& canvas, const Box& box, std::string_view symbol, std::string_view title,
    std::string_view note);
float heading_height(const Canvas& canvas);

/// Draws a sheet with round corners over something else.
void sheet(const Canvas& canvas, const Box& box, Colour shade, Colour edge);

/// Width of the thinnest line.
float hairline(const Canvas& canvas);

/// Wrapped text with formulas; whole sentences are left out if it would need more than `most_lines`.
float paragraph(
    const Canvas& canvas, const Box& box, const ImFont* font, Colour colour, std::string_view text,
    std::size_t most_lines = 100);

/// Height that the whole paragraph needs.
float paragraph_height(const Canvas& canvas, const ImFont* font, std::string_view text, float width);

/// Value of an equation as text: "0.0123", "-1.2e-07", and "0" for rounding.
std::string live_text(double value);

/// Number with fewer decimals from 100 on, so that it fits into a column and the point rarely moves.
std::string column_text(double value, int decimals);

}  // namespace jw::panels
