#pragma once

#include "app/panels/parts/parts.hpp"
#include "app/session/view/view.hpp"

namespace jw::panels {

/// Φq as a coloured matrix: blue below 0, orange above 0, blank for 0. The rows of the step are highlighted;
/// redundant rows are hatched and marked "=".
/// @return height taken
float matrix_panel(const Canvas& canvas, const Box& box, const MatrixView& matrix);

/// @param cell  height of a row, at 720
float matrix_panel_height(const Canvas& canvas, const MatrixView& matrix, float cell);

/// Colour of an entry; `largest` is the largest size in the matrix. The colour depends on the square root of
/// the size, so that a tenth of the largest is still visible.
Colour colour_of_entry(double value, double largest);

}  // namespace jw::panels
