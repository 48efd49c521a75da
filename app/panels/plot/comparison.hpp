#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "app/panels/plot/plot.hpp"

/// Ways side by side: a table with a row for each, what it says in a sentence, and a plot with a curve for
/// each.
namespace jw::panels {

struct CurveStyle;

struct ComparisonLayout {
    std::vector<Box> rows;  ///< of the table, for the mouse
    PlotLayout plot;        ///< empty panes where there is no room for it
};

/// Parts in which one comparison differs from another.
struct ComparisonParts {
    std::size_t rows = 0;
    std::function<void(const Box& line)> draw_names;  ///< of the columns
    /// @param style of the row's curve, which it keeps while another one is hovered
    std::function<void(const Box& line, std::size_t row, const CurveStyle& style)> draw_row;
    std::string_view summary;
    std::string_view caption;  ///< of the plot
};

/// Below a heading, which is the caller's.
/// @param state  of the plot; the way that is hovered stands out in table and plot
ComparisonLayout draw_comparison(
    const Canvas& canvas, const Box& box, const SeriesSet& curves, const ComparisonParts& parts,
    const PlotState& state);

}  // namespace jw::panels
