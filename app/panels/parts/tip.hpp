#pragma once

#include <string>
#include <vector>

#include "app/panels/parts/canvas.hpp"

namespace jw::panels {

/// Where a tip goes and how it looks.
struct TipPlace {
    Box beside;  ///< what it is about; it does not cover that where there is room
    Box within;  ///< it never leaves this
};

/// Draws lines with formulas on a sheet of their size. What is too wide or too high for the place is left
/// out, a whole line at a time.
/// @return the sheet; of no width where nothing fits
Box draw_tip(const Canvas& canvas, const TipPlace& place, const std::vector<std::string>& lines);

}  // namespace jw::panels
