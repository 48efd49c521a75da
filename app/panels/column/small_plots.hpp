#pragma once

#include <vector>

#include "app/panels/parts/parts.hpp"
#include "app/session/view/view.hpp"

/// Small plots of a step over powers of ten, without names of curves, and without actions of the mouse.
namespace jw::panels {

/// Singular values, largest first: those below the threshold count as zero, and are hollow.
void singular_values_plot(const Canvas& canvas, const Box& box, const RankView& rank);

/// ‖Φ‖ of every iteration; the last one is that of the step.
void convergence_plot(const Canvas& canvas, const Box& box, const std::vector<NewtonRow>& rows);

}  // namespace jw::panels
