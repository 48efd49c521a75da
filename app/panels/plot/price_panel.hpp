#pragma once

#include "app/panels/plot/comparison.hpp"
#include "app/session/benchmark/prices.hpp"

/// Speed against error: a table of the times needed to reach an error, and one plot of CPU time over digits.
namespace jw::panels {

/// @param note   beside the heading: the scene, or the progress of the measurement
/// @param state  of the plot; the hovered method is highlighted in table and plot
ComparisonLayout price_panel(
    const Canvas& canvas, const Box& box, const Prices& prices, std::string_view note,
    const PlotState& state);

}  // namespace jw::panels
