#pragma once

#include "app/panels/plot/comparison.hpp"
#include "app/session/benchmark/newton_comparison.hpp"

/// Comparison of Newton's methods: a table, and one plot of ‖Φ‖ over the iterations of all of them.
namespace jw::panels {

/// @param state  of the plot; the hovered method is highlighted in table and plot
ComparisonLayout newton_comparison_panel(
    const Canvas& canvas, const Box& box, const NewtonComparison& comparison, const PlotState& state);

}  // namespace jw::panels
