#include "app/panels/plot/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include <imgui.h>

#include "app/panels/parts/parts.hpp"
#include "app/panels/parts/text_lines.hpp"
#include "app/panels/parts/theme.hpp"
#include "app/panels/plot/plot_parts.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"

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

/// Parts in which comparisons differ.
struct ComparisonParts {
    std::size_t rows = 0;
    std::function<void(const Box& line)> draw_names;  ///< of the columns
    /// @param style of the row's curve, also while another one is hovered
    std::function<void(const Box& line, std::size_t row, const CurveStyle& style)> draw_row;
    std::string_view summary;
    std::string_view caption;  ///< of the plot
};

/// Draws a comparison below a heading, which the caller has drawn.
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

/// Draws a text of a row at a part of its width.
void draw_cell(
    const Canvas& canvas, const Box& row, float part, Colour colour, std::string_view text,
    Align align = Align::right) {
    canvas.text({row.x + part * row.width, row.y}, canvas.fonts().small, colour, text, align);
}

/// Draws the title of the first column.
void draw_first_title(const Canvas& canvas, const Box& row, std::string_view text) {
    canvas.text({row.x + name_indent(canvas), row.y}, canvas.fonts().small, theme::kSoft, text);
}

/// Draws the mark of a curve, and its name.
void draw_method(const Canvas& canvas, const Box& row, const CurveStyle& style, std::string_view name) {
    const ImFont* const small = canvas.fonts().small;
    draw_curve_mark(canvas, {row.x + mark_indent(canvas), row.y + 0.5F * canvas.line_height(small)}, style);
    canvas.text({row.x + name_indent(canvas), row.y}, small, style.colour, name);
}

constexpr float kRoomForTurns = 560.0F;  // least width to show turns; below it, the outcome needs the room

/// Right edges of the columns in parts of the width; names and outcomes are left-aligned.
struct Columns {
    float iterations = 0.41F;
    float phi = 0.57F;
    float order = 0.68F;
    float turn = 0.0F;      ///< 0: left out
    float verdict = 0.71F;  ///< left edge
};

/// Verdict with its sign: "✓ closed".
std::string with_sign(bool closed, const std::string& verdict) { return (closed ? "✓ " : "✗ ") + verdict; }

Columns columns_of(const Canvas& canvas, const Box& row) {
    const auto part = [&](const char* text) {
        return (canvas.text_width(canvas.fonts().small, text) + canvas.px(8.0F)) / row.width;
    };
    if (row.width < canvas.px(kRoomForTurns)) {
        const Columns usual;
        if (usual.phi - usual.iterations >= part(tr("last ‖Φ‖"))) { return usual; }
        // large text in a narrow column: columns are as wide as their numbers, and the names get the rest
        Columns narrow;
        narrow.verdict = 1.0F - part(with_sign(true, tr("closed")).c_str());
        narrow.order = narrow.verdict - part(" ");
        narrow.phi = narrow.order - part(tr("order"));
        narrow.iterations = narrow.phi - part(tr("last ‖Φ‖"));
        return narrow;
    }
    return {0.42F, 0.55F, 0.64F, 0.74F, 0.77F};
}

void draw_newton_names(const Canvas& canvas, const Box& row) {
    const Columns columns = columns_of(canvas, row);
    draw_first_title(canvas, row, tr("method"));
    draw_cell(canvas, row, columns.iterations, theme::kSoft, tr("steps"));
    draw_cell(canvas, row, columns.phi, theme::kSoft, tr("last ‖Φ‖"));
    draw_cell(canvas, row, columns.order, theme::kSoft, tr("order"));
    if (columns.turn > 0.0F) { draw_cell(canvas, row, columns.turn, theme::kSoft, tr("turn")); }
    draw_cell(canvas, row, columns.verdict, theme::kSoft, tr("outcome"), Align::left);
}

void draw_newton_row(const Canvas& canvas, const Box& row, const NewtonRunRow& run, const CurveStyle& style) {
    const ImFont& small = *canvas.fonts().small;
    const Columns columns = columns_of(canvas, row);
    const float room = (columns.iterations - 0.08F) * row.width - name_indent(canvas);
    draw_method(canvas, row, style, shortened(small, run.name, room));
    draw_cell(canvas, row, columns.iterations, theme::kInk, std::to_string(run.iterations));
    draw_cell(canvas, row, columns.phi, theme::kInk, small_text(run.phi_norm));
    draw_cell(canvas, row, columns.order, theme::kInk, run.order);
    if (columns.turn > 0.0F) { draw_cell(canvas, row, columns.turn, theme::kInk, run.turn); }
    const float verdict = row.x + columns.verdict * row.width;
    draw_cell(
        canvas, row, columns.verdict, run.closed ? theme::kInk : theme::kRedundant,
        shortened(small, with_sign(run.closed, run.verdict), row.right() - verdict), Align::left);
}

/// Right edge of a column of the table, in parts of its width; the last column shows the least error.
float column(std::size_t k) {
    constexpr float first = 0.46F;
    constexpr float width = 0.18F;
    return first + width * static_cast<float>(k);
}

void draw_price_names(const Canvas& canvas, const Box& row) {
    draw_first_title(canvas, row, tr("ms for an error below"));
    for (std::size_t level = 0; level < kErrorLevels.size(); ++level) {
        draw_cell(canvas, row, column(level), theme::kSoft, level_text(level));
    }
    draw_cell(canvas, row, column(kErrorLevels.size()), theme::kSoft, tr("at best [m]"));
}

void draw_price_row(const Canvas& canvas, const Box& row, const PriceRow& price, const CurveStyle& style) {
    draw_method(canvas, row, style, price.name);
    for (std::size_t level = 0; level < kErrorLevels.size(); ++level) {
        const auto& time = price.milliseconds[level];
        draw_cell(canvas, row, column(level), theme::kInk, time ? number_text(*time, 3) : "–");
    }
    const std::string finest = std::isnan(price.finest) ? "–" : small_text(price.finest);
    draw_cell(canvas, row, column(kErrorLevels.size()), theme::kInk, finest);
}

}  // namespace

ComparisonLayout newton_comparison_panel(
    const Canvas& canvas, const Box& box, const NewtonComparison& comparison, const PlotState& state) {
    Box rest = box;
    cut_top(rest, heading(canvas, rest, tr("Newton, method by method"), tr("from the same start")));
    const ComparisonParts parts{
        comparison.rows.size(), [&](const Box& line) { draw_newton_names(canvas, line); },
        [&](const Box& line, std::size_t row, const CurveStyle& style) {
            draw_newton_row(canvas, line, comparison.rows[row], style);
        },
        comparison.summary, tr("‖Φ‖ after each step")};
    return draw_comparison(canvas, rest, comparison.residuals, parts, state);
}

ComparisonLayout price_panel(
    const Canvas& canvas, const Box& box, const Prices& prices, std::string_view note,
    const PlotState& state) {
    Box rest = box;
    cut_top(rest, heading(canvas, rest, tr("Speed against error"), note));
    const ComparisonParts parts{
        prices.rows.size(), [&](const Box& line) { draw_price_names(canvas, line); },
        [&](const Box& line, std::size_t row, const CurveStyle& style) {
            draw_price_row(canvas, line, prices.rows[row], style);
        },
        prices.summary, tr("CPU time against correct digits of position")};
    return draw_comparison(canvas, rest, prices.curves, parts, state);
}

}  // namespace jw::panels
