#include "app/panels/plot/comparison.hpp"

#include <algorithm>

#include <imgui.h>

#include "app/panels/parts/parts.hpp"
#include "app/panels/parts/text_lines.hpp"
#include "app/panels/parts/theme.hpp"
#include "app/panels/plot/plot_parts.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"

namespace jw::panels {

namespace {

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

void draw_names(const Canvas& canvas, const Box& row) {
    const ImFont* const small = canvas.fonts().small;
    const Columns columns = columns_of(canvas, row);
    const auto name = [&](float part, const char* text, Align align) {
        canvas.text({row.x + part * row.width, row.y}, small, theme::kSoft, text, align);
    };
    canvas.text({row.x + name_indent(canvas), row.y}, small, theme::kSoft, tr("method"));
    name(columns.iterations, tr("steps"), Align::right);
    name(columns.phi, tr("last ‖Φ‖"), Align::right);
    name(columns.order, tr("order"), Align::right);
    if (columns.turn > 0.0F) { name(columns.turn, tr("turn"), Align::right); }
    name(columns.verdict, tr("outcome"), Align::left);
}

void draw_row(const Canvas& canvas, const Box& row, const NewtonRunRow& run, const CurveStyle& style) {
    const ImFont* const small = canvas.fonts().small;
    const Columns columns = columns_of(canvas, row);
    const float middle = row.y + 0.5F * canvas.line_height(small);
    draw_curve_mark(canvas, {row.x + mark_indent(canvas), middle}, style);
    const float left = row.x + name_indent(canvas);
    const float room = (columns.iterations - 0.08F) * row.width - name_indent(canvas);
    canvas.text({left, row.y}, small, style.colour, shortened(*small, run.name, room));
    const auto number = [&](float part, const std::string& text) {
        canvas.text({row.x + part * row.width, row.y}, small, theme::kInk, text, Align::right);
    };
    number(columns.iterations, std::to_string(run.iterations));
    number(columns.phi, small_text(run.phi_norm));
    number(columns.order, run.order);
    if (columns.turn > 0.0F) { number(columns.turn, run.turn); }
    const float verdict = row.x + columns.verdict * row.width;
    canvas.text(
        {verdict, row.y}, small, run.closed ? theme::kInk : theme::kRedundant,
        shortened(*small, with_sign(run.closed, run.verdict), row.right() - verdict));
}

}  // namespace

ComparisonLayout newton_comparison_panel(
    const Canvas& canvas, const Box& box, const NewtonComparison& comparison, const PlotState& state) {
    Box rest = box;
    cut_top(rest, heading(canvas, rest, tr("Newton, method by method"), tr("from the same start")));
    ComparisonParts parts;
    parts.rows = comparison.rows.size();
    parts.draw_names = [&](const Box& line) { draw_names(canvas, line); };
    parts.draw_row = [&](const Box& line, std::size_t row, const CurveStyle& style) {
        draw_row(canvas, line, comparison.rows[row], style);
    };
    parts.summary = comparison.summary;
    parts.caption = tr("‖Φ‖ after each step");
    return draw_comparison(canvas, rest, comparison.residuals, parts, state);
}

}  // namespace jw::panels
