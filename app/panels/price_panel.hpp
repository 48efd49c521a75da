#pragma once

#include "app/panels/plot.hpp"
#include "app/session/prices.hpp"

/// Speed against error: a table of what it takes to come within an error, and one plot of CPU time over
/// digits.
namespace jw::panels {

struct PricePanelLayout {
    std::vector<Box> rows;  ///< of the table, one a method, for the mouse
    PlotLayout plot;        ///< empty panes where there is no room for it
};

/// @param note   beside the heading: the scene, or how far the measurement has come
/// @param state  of the plot; the method that is hovered stands out in table and plot
PricePanelLayout price_panel(
    const Canvas& canvas, const Box& box, const Prices& prices, std::string_view note,
    const PlotState& state);

}  // namespace jw::panels
