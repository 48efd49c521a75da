#include "app/panels/price_panel.hpp"

#include <cmath>

#include <imgui.h>

#include "app/panels/parts.hpp"
#include "app/panels/plot_parts.hpp"
#include "app/panels/text.hpp"
#include "app/panels/theme.hpp"
#include "app/session/numbers.hpp"

namespace jw::panels {

namespace {

constexpr float kLeastPlot = 6.0F;  // height worth drawing, in lines

/// Right edge of a column of the table, in parts of its width; the last one is the least error.
float column(std::size_t k) {
    constexpr float first = 0.46F;
    constexpr float width = 0.18F;
    return first + width * static_cast<float>(k);
}

void draw_names(const Canvas& canvas, const Box& row) {
    const ImFont* const small = canvas.fonts().small;
    canvas.text({row.x + name_indent(canvas), row.y}, small, theme::kSoft, "ms to come within");
    const auto name = [&](std::size_t k, const std::string& text) {
        canvas.text({row.x + column(k) * row.width, row.y}, small, theme::kSoft, text, Align::right);
    };
    for (std::size_t level = 0; level < kErrorLevels.size(); ++level) { name(level, level_text(level)); }
    name(kErrorLevels.size(), "at best [m]");
}

void draw_row(const Canvas& canvas, const Box& row, const PriceRow& price, const CurveStyle& style) {
    const ImFont* const small = canvas.fonts().small;
    const float middle = row.y + 0.5F * canvas.line_height(small);
    draw_curve_mark(canvas, {row.x + mark_indent(canvas), middle}, style);
    canvas.text({row.x + name_indent(canvas), row.y}, small, style.colour, price.name);
    const auto number = [&](std::size_t k, const std::string& text) {
        canvas.text({row.x + column(k) * row.width, row.y}, small, theme::kInk, text, Align::right);
    };
    for (std::size_t level = 0; level < kErrorLevels.size(); ++level) {
        const auto& time = price.milliseconds[level];
        number(level, time ? number_text(*time, 3) : "–");
    }
    number(kErrorLevels.size(), std::isnan(price.finest) ? "–" : small_text(price.finest));
}

/// The curves of the plot in the order of the methods, for their colours and marks.
PlotPane pane_of(const SeriesSet& set) {
    PlotPane pane;
    pane.series.resize(set.series.size());
    for (std::size_t k = 0; k < set.series.size(); ++k) { pane.series[k] = static_cast<int>(k); }
    return pane;
}

}  // namespace

PricePanelLayout price_panel(
    const Canvas& canvas, const Box& box, const Prices& prices, std::string_view note,
    const PlotState& state) {
    PricePanelLayout layout;
    const ImFont* const small = canvas.fonts().small;
    const float line = canvas.line_height(small);
    Box rest = box;
    cut_top(rest, heading(canvas, rest, "Speed against error", note));
    if (!prices.rows.empty()) { draw_names(canvas, cut_top(rest, line + canvas.px(3.0F))); }
    const PlotPane pane = pane_of(prices.curves);
    for (std::size_t k = 0; k < prices.rows.size(); ++k) {
        const Box row = cut_top(rest, line + canvas.px(2.0F));
        if (row.height < line) { break; }
        if (static_cast<int>(k) == state.hovered) { canvas.fill(row, theme::kSubject, canvas.px(2.0F)); }
        draw_row(canvas, row, prices.rows[k], style_of(pane, k, prices.curves, {}));
        layout.rows.push_back(row);
    }
    const float words = paragraph(canvas.measuring(), rest, small, theme::kInk, prices.summary);
    if (rest.height >= words) {
        cut_top(rest, canvas.px(5.0F));
        paragraph(canvas, cut_top(rest, words), small, theme::kInk, prices.summary);
        cut_top(rest, canvas.px(10.0F));
    }
    if (rest.height < kLeastPlot * line) { return layout; }
    canvas.text({rest.x, rest.y}, small, theme::kSoft, "CPU time over the digits of position that it buys");
    cut_top(rest, line);
    layout.plot = layout_plot(canvas, rest, prices.curves, state);
    // curves that end on top of each other have their names in the table above
    for (PlotPane& drawn : layout.plot.panes) { drawn.unnamed = 0; }
    draw_plot(canvas, layout.plot, prices.curves, state);
    return layout;
}

}  // namespace jw::panels
