#pragma once

#include "app/panels/plot.hpp"
#include "app/session/newton_comparison.hpp"

/// Methods of Newton side by side: a table, and one plot of ‖Φ‖ over the iterations of all of them.
namespace jw::panels {

struct NewtonComparisonLayout {
    std::vector<Box> rows;  ///< of the table, one a method, for the mouse
    PlotLayout plot;        ///< empty panes where there is no room for it
};

/// @param state  of the plot; the method that is hovered stands out in table and plot
NewtonComparisonLayout newton_comparison_panel(
    const Canvas& canvas, const Box& box, const NewtonComparison& comparison, const PlotState& state);

}  // namespace jw::panels
