#include "app/panels/plot/comparison.hpp"

#include <cmath>

#include <imgui.h>

#include "app/panels/parts/parts.hpp"
#include "app/panels/parts/theme.hpp"
#include "app/panels/plot/plot_parts.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"

namespace jw::panels {

namespace {

/// Right edge of a column of the table, in parts of its width; the last column shows the least error.
float column(std::size_t k) {
    constexpr float first = 0.46F;
    constexpr float width = 0.18F;
    return first + width * static_cast<float>(k);
}

void draw_price_names(const Canvas& canvas, const Box& row) {
    const ImFont* const small = canvas.fonts().small;
    canvas.text({row.x + name_indent(canvas), row.y}, small, theme::kSoft, tr("ms for an error below"));
    const auto name = [&](std::size_t k, const std::string& text) {
        canvas.text({row.x + column(k) * row.width, row.y}, small, theme::kSoft, text, Align::right);
    };
    for (std::size_t level = 0; level < kErrorLevels.size(); ++level) { name(level, level_text(level)); }
    name(kErrorLevels.size(), tr("at best [m]"));
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

}  // namespace

ComparisonLayout price_panel(
    const Canvas& canvas, const Box& box, const Prices& prices, std::string_view note,
    const PlotState& state) {
    Box rest = box;
    cut_top(rest, heading(canvas, rest, tr("Speed against error"), note));
    ComparisonParts parts;
    parts.rows = prices.rows.size();
    parts.draw_names = [&](const Box& line) { draw_price_names(canvas, line); };
    parts.draw_row = [&](const Box& line, std::size_t row, const CurveStyle& style) {
        draw_row(canvas, line, prices.rows[row], style);
    };
    parts.summary = prices.summary;
    parts.caption = tr("CPU time against correct digits of position");
    return draw_comparison(canvas, rest, prices.curves, parts, state);
}

}  // namespace jw::panels
