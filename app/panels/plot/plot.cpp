#include "app/panels/plot/plot.hpp"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "app/panels/parts/parts.hpp"
#include "app/panels/parts/text_lines.hpp"
#include "app/panels/parts/theme.hpp"
#include "app/panels/plot/plot_parts.hpp"
#include "app/session/wording/messages.hpp"

namespace jw::panels {

namespace {

constexpr float kMarkDistance = 84.0F;  // between the marks along one curve
constexpr float kEveryPoint = 22.0F;    // if points are farther apart than this, each one is marked
constexpr float kLongestLeader = 5.0F;  // from a curve to its name, in lines; longer ones do not help

void draw_empty(const Canvas& canvas, const PlotLayout& layout) {
    const ImFont* const font = canvas.fonts().normal;
    const Box inner = shrunk(layout.box, canvas.px(24.0F), 0.0F);
    const float height = paragraph(canvas.measuring(), inner, font, theme::kSoft, layout.empty);
    canvas.outline(shrunk(layout.box, 1.0F, 1.0F), theme::kLine, hairline(canvas));
    paragraph(
        canvas, {inner.x, layout.box.centre().y - 0.5F * height, inner.width, height}, font, theme::kSoft,
        layout.empty);
}

void draw_values_axis(const Canvas& canvas, const PlotPane& pane) {
    const ImFont* const small = canvas.fonts().small;
    const float thin = hairline(canvas);
    const float tick = canvas.px(4.0F);
    for (const Tick& t : pane.ticks.ticks) {
        const float y = std::round(pane.y.pixel(t.at));
        canvas.fill({pane.plot.x, y, pane.plot.width, thin}, theme::kLine);
        canvas.fill({pane.plot.x - tick, y, tick, thin}, theme::kSoft);
        canvas.text(
            {pane.plot.x - 2.0F * tick, y - 0.55F * canvas.line_height(small)}, small, theme::kSoft, t.text,
            Align::right);
    }
    canvas.text(pane.caption_at, small, theme::kSoft, pane.caption);
}

/// Draws the line of zero if values have both signs.
void draw_zero(const Canvas& canvas, const PlotPane& pane) {
    if (pane.y.logarithmic || pane.y.range.from >= 0.0 || pane.y.range.to <= 0.0) { return; }
    const float y = std::round(pane.y.pixel(0.0));
    canvas.fill({pane.plot.x, y, pane.plot.width, hairline(canvas)}, theme::kFaint);
}

void draw_frame_lines(const Canvas& canvas, const PlotPane& pane) {
    const float thin = hairline(canvas);
    canvas.fill({pane.plot.x, pane.plot.y, thin, pane.plot.height}, theme::kSoft);
    canvas.fill({pane.plot.x, pane.plot.bottom(), pane.plot.width, thin}, theme::kSoft);
}

void draw_lower_axis(const Canvas& canvas, const PlotLayout& layout) {
    const ImFont* const small = canvas.fonts().small;
    const float thin = hairline(canvas);
    const float tick = canvas.px(4.0F);
    const float line = canvas.line_height(small);
    const float bottom = layout.panes.back().plot.bottom();
    for (const Tick& t : layout.ticks.ticks) {
        const float x = std::round(layout.x.pixel(t.at));
        for (const PlotPane& pane : layout.panes) {
            canvas.fill({x, pane.plot.y, thin, pane.plot.height}, theme::kLine);
        }
        canvas.fill({x, bottom, thin, tick}, theme::kSoft);
        const float width = canvas.text_width(small, t.text);
        const Box text{x - 0.5F * width, layout.axis_box.y, width, line};
        const bool free = !overlap(shrunk(text, -canvas.px(5.0F), 0.0F), layout.axis_box) &&
                          text.right() <= layout.box.right() &&
                          !(layout.cursor && overlap(text, layout.cursor_box));
        if (free) { canvas.text({x, text.y}, small, theme::kSoft, t.text, Align::centre); }
    }
    if (!(layout.cursor && overlap(layout.axis_box, layout.cursor_box))) {
        canvas.text({layout.axis_box.x, layout.axis_box.y}, small, theme::kSoft, layout.axis);
    }
}

/// Right end of the text in the line above a pane.
float right_of_caption(const Canvas& canvas, const PlotPane& pane) {
    const ImFont* const small = canvas.fonts().small;
    return pane.caption.empty() ? pane.plot.x : pane.caption_at.x + canvas.text_width(small, pane.caption);
}

void draw_marks(const Canvas& canvas, const PlotLayout& layout) {
    const float width = std::max(1.0F, canvas.px(1.4F));
    for (const PlotMark& mark : layout.marks) {
        for (const PlotPane& pane : layout.panes) {
            if (mark.count > 1) {
                const float breadth = std::max(width, mark.end - mark.x);
                canvas.fill(
                    {mark.x, pane.plot.y, breadth, pane.plot.height},
                    render::with_alpha(theme::kSubject, 0.4F));
            }
            const bool first = &pane == &layout.panes.front() && !mark.text.empty();
            for (const float edge : {mark.x, mark.end}) {
                const float x = std::round(edge);
                const bool free = first && mark.count == 1 && x > right_of_caption(canvas, pane);
                const float top = free ? mark.box.bottom() : pane.plot.y;
                canvas.dashed_line({x, top}, {x, pane.plot.bottom()}, theme::kSubjectMark, width);
                if (mark.count == 1) { break; }
            }
        }
    }
    // after all lines: the line of a mark in the upper row may pass through a text of the lower one
    for (const PlotMark& mark : layout.marks) {
        if (mark.text.empty()) { continue; }
        canvas.fill(mark.box, theme::kPaper);
        canvas.text({mark.box.x, mark.box.y}, canvas.fonts().small, theme::kWarning, mark.text);
    }
}

/// Draws marks at every point if there are few, else at intervals, at different places for each curve.
void draw_marks_along(
    const Canvas& canvas, const PlotPane& pane, const std::vector<Point>& run, const CurveStyle& style,
    std::size_t place) {
    if (!style.marked) { return; }
    const bool each = run.size() < 2 || (run.back().x - run.front().x) / static_cast<float>(run.size() - 1) >=
                                            canvas.px(kEveryPoint);
    const float distance = canvas.px(kMarkDistance);
    float next =
        std::max(pane.plot.x, run.front().x) + distance * (0.3F + 0.37F * static_cast<float>(place % 3));
    const Box around = shrunk(pane.plot, -1.0F, -1.0F);
    // a curve that ends before its first mark has one at its end
    if (!each && run.back().x < next && around.contains(run.back())) {
        draw_curve_mark(canvas, run.back(), style);
    }
    for (const Point p : run) {
        if (!around.contains(p) || (!each && p.x < next)) { continue; }
        draw_curve_mark(canvas, p, style);
        next += distance * std::max(1.0F, std::ceil((p.x - next) / distance));
    }
}

/// Draws the mark of a curve and a text, on a background of paper if curves run below. Names keep their
/// colour while another curve is highlighted, because pale letters are hard to read.
void draw_label(
    const Canvas& canvas, const PlotPane& pane, const PlotLabel& label, const SeriesSet& set, bool on_paper) {
    const auto place = std::ranges::find(pane.series, label.series) - pane.series.begin();
    const CurveStyle style = style_of(pane, static_cast<std::size_t>(place), set, {});
    if (on_paper) {
        const Box paper = shrunk(label.box, -canvas.px(2.0F), 0.0F);
        canvas.fill(paper, render::with_alpha(theme::kPaper, 0.88F), canvas.px(2.0F));
    }
    const float middle = label.box.y + 0.5F * label.box.height;
    if (style.marked) { draw_curve_mark(canvas, {label.box.x + mark_indent(canvas), middle}, style); }
    const float x = label.box.x + name_indent(canvas);
    canvas.text({x, label.box.y}, canvas.fonts().small, style.colour, label.text);
}

void draw_labels(const Canvas& canvas, const PlotPane& pane, const SeriesSet& set) {
    for (const PlotLabel& label : pane.labels) {
        const float middle = label.box.y + 0.5F * label.box.height;
        const bool near = std::abs(label.anchor.y - middle) < kLongestLeader * label.box.height;
        if (label.box.x > pane.plot.right() && near) {
            const Point to{label.box.x - canvas.px(2.0F), middle};
            canvas.line({pane.plot.right() + canvas.px(1.0F), label.anchor.y}, to, theme::kFaint, 1.0F);
        }
        draw_label(canvas, pane, label, set, false);
    }
}

void draw_cursor(const Canvas& canvas, const PlotLayout& layout, const SeriesSet& set) {
    if (!layout.cursor) { return; }
    for (const PlotPane& pane : layout.panes) {
        const float length = pane.plot.height + canvas.px(4.0F);
        canvas.fill({*layout.cursor, pane.plot.y, hairline(canvas), length}, theme::kInk);
        for (const PlotLabel& value : pane.values) {
            canvas.disc(value.anchor, canvas.px(3.0F), theme::kInk);
            draw_label(canvas, pane, value, set, true);
        }
    }
    canvas.fill(layout.cursor_box, theme::kInk, canvas.px(3.0F));
    canvas.text(
        {layout.cursor_box.centre().x, layout.cursor_box.y}, canvas.fonts().small, theme::kWhite,
        layout.cursor_text, Align::centre);
}

/// Writes how many names and units are left out, at the end of the line of the first caption.
void draw_left_out(const Canvas& canvas, const PlotLayout& layout) {
    int unnamed = 0;
    for (const PlotPane& pane : layout.panes) { unnamed += pane.unnamed; }
    std::string text;
    if (unnamed > 0) { text = tr_count(unnamed, "{0} curve not named", "{0} curves not named"); }
    if (layout.left_out > 0) {
        const std::string units = tr_count(
            layout.left_out, "{0} unit not shown: not enough height",
            "{0} units not shown: not enough height");
        text = text.empty() ? units : tr("{0}, {1}", text, units);
    }
    const PlotPane& first = layout.panes.front();
    const float room = first.plot.right() - right_of_caption(canvas, first) - canvas.px(10.0F);
    canvas.text(
        {first.plot.right(), first.caption_at.y}, canvas.fonts().small, theme::kFaint,
        shortened(*canvas.fonts().small, text, std::max(0.0F, room)), Align::right);
}

}  // namespace

void draw_plot(const Canvas& canvas, const PlotLayout& layout, const SeriesSet& set, const PlotState& state) {
    if (layout.panes.empty()) {
        draw_empty(canvas, layout);
        return;
    }
    draw_lower_axis(canvas, layout);
    for (const PlotPane& pane : layout.panes) {
        draw_values_axis(canvas, pane);
        draw_zero(canvas, pane);
    }
    draw_marks(canvas, layout);
    for (const PlotPane& pane : layout.panes) {
        for (std::size_t k = 0; k < pane.series.size(); ++k) {
            const CurveStyle style = style_of(pane, k, set, state);
            for (const auto& run : curve_of(layout, pane, set, pane.series[k])) {
                draw_curve(canvas, pane.plot, run, style);
                draw_marks_along(canvas, pane, run, style, k);
            }
        }
        draw_frame_lines(canvas, pane);
        draw_labels(canvas, pane, set);
    }
    draw_left_out(canvas, layout);
    draw_cursor(canvas, layout, set);
}

}  // namespace jw::panels
