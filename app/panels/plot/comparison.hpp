#pragma once

#include <string_view>
#include <vector>

#include "app/panels/plot/plot.hpp"
#include "app/session/benchmark/newton_comparison.hpp"
#include "app/session/benchmark/prices.hpp"

/// Comparison of several methods: a table with a row for each, a sentence about the result, and a plot with a
/// curve for each.
namespace jw::panels {

struct ComparisonLayout {
    std::vector<Box> rows;  ///< of the table, for the mouse
    PlotLayout plot;        ///< without panes if there is no room for it
};

/// Comparison of Newton's methods, with one plot of ‖Φ‖ over the iterations of all of them.
ComparisonLayout newton_comparison_panel(
    const Canvas& canvas, const Box& box, const NewtonComparison& comparison, const PlotState& state);

/// Speed against error: a table of the times needed to reach an error, and one plot of CPU time over digits.
/// @param note  beside the heading: the scene, or the progress of the measurement
ComparisonLayout price_panel(
    const Canvas& canvas, const Box& box, const Prices& prices, std::string_view note,
    const PlotState& state);

}  // namespace jw::panels
