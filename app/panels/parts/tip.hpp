#pragma once

#include <string>
#include <vector>

#include "app/panels/parts/canvas.hpp"

namespace jw::panels {

/// Place of a tip.
struct TipPlace {
    Box beside;  ///< subject of the tip, which the tip does not cover if there is room
    Box within;  ///< the tip stays in this box
};

/// Draws lines with formulas on a sheet of their size. Lines that are too wide or too high for the place are
/// left out.
/// @return the sheet; width 0 if nothing fits
Box draw_tip(const Canvas& canvas, const TipPlace& place, const std::vector<std::string>& lines);

}  // namespace jw::panels
