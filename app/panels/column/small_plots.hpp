#pragma once

#include <vector>

#include "app/panels/parts/parts.hpp"
#include "app/session/view/view.hpp"

/// Small plots of a step over powers of ten: without a name at a curve, and nothing to be done to them.
namespace jw::panels {

/// Singular values, largest first: hollow under the threshold, which is where zero begins.
void singular_values_plot(const Canvas& canvas, const Box& box, const RankView& rank);

/// ‖Φ‖ of every iteration; the last one is the step's.
void convergence_plot(const Canvas& canvas, const Box& box, const std::vector<NewtonRow>& rows);

}  // namespace jw::panels
