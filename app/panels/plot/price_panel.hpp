#pragma once

#include "app/panels/plot/comparison.hpp"
#include "app/session/benchmark/prices.hpp"

/// Speed against error: a table of what it takes to come within an error, and one plot of CPU time over
/// digits.
namespace jw::panels {

/// @param note   beside the heading: the scene, or how far the measurement has come
/// @param state  of the plot; the method that is hovered stands out in table and plot
ComparisonLayout price_panel(
    const Canvas& canvas, const Box& box, const Prices& prices, std::string_view note,
    const PlotState& state);

}  // namespace jw::panels
