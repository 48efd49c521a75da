#pragma once

#include "app/panels/parts/parts.hpp"
#include "app/session/view/view.hpp"

namespace jw::panels {

/// Φq as a coloured matrix: blue below 0, orange above, blank where there is nothing; the rows of the step
/// stand out, those that repeat others are hatched and marked "=".
/// @return height taken
float matrix_panel(const Canvas& canvas, const Box& box, const MatrixView& matrix);

/// @param cell  height of a row, at 720
float matrix_panel_height(const Canvas& canvas, const MatrixView& matrix, float cell);

/// Colour of an entry; `largest` is that of the whole matrix. Sizes are shown by their square root, so that
/// a tenth of the largest is still seen.
Colour colour_of_entry(double value, double largest);

}  // namespace jw::panels
