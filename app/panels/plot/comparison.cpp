#include "app/panels/plot/comparison.hpp"

#include <numeric>

#include <imgui.h>

#include "app/panels/parts/parts.hpp"
#include "app/panels/parts/theme.hpp"
#include "app/panels/plot/plot_parts.hpp"

namespace jw::panels {

namespace {

constexpr float kLeastPlot = 6.0F;  // least useful height, in lines

/// A pane with the curves in the order of the rows, which gives their colours and marks.
PlotPane pane_of(const SeriesSet& set) {
    PlotPane pane;
    pane.series.resize(set.series.size());
    std::iota(pane.series.begin(), pane.series.end(), 0);
    return pane;
}

}  // namespace

ComparisonLayout draw_comparison(
    const Canvas& canvas, const Box& box, const SeriesSet& curves, const ComparisonParts& parts,
    const PlotState& state) {
    ComparisonLayout layout;
    const ImFont* const small = canvas.fonts().small;
    const float line = canvas.line_height(small);
    Box rest = box;
    if (parts.rows > 0) { parts.draw_names(cut_top(rest, line + canvas.px(3.0F))); }
    const PlotPane pane = pane_of(curves);
    for (std::size_t k = 0; k < parts.rows; ++k) {
        const Box row = cut_top(rest, line + canvas.px(2.0F));
        if (row.height < line) { break; }
        if (static_cast<int>(k) == state.hovered) { canvas.fill(row, theme::kSubject, canvas.px(2.0F)); }
        parts.draw_row(row, k, style_of(pane, k, curves, {}));
        layout.rows.push_back(row);
    }
    const float words = paragraph(canvas.measuring(), rest, small, theme::kInk, parts.summary);
    if (rest.height >= words) {
        cut_top(rest, canvas.px(5.0F));
        paragraph(canvas, cut_top(rest, words), small, theme::kInk, parts.summary);
        cut_top(rest, canvas.px(10.0F));
    }
    if (rest.height < kLeastPlot * line) { return layout; }
    canvas.text({rest.x, rest.y}, small, theme::kSoft, std::string(parts.caption));
    cut_top(rest, line);
    layout.plot = layout_plot(canvas, rest, curves, state);
    // curves without a name at their end have it in the table above
    for (PlotPane& drawn : layout.plot.panes) { drawn.unnamed = 0; }
    draw_plot(canvas, layout.plot, curves, state);
    return layout;
}

}  // namespace jw::panels
