#include <algorithm>
#include <array>
#include <cmath>

#include <imgui.h>

#include "app/panels/parts/text_lines.hpp"
#include "app/panels/plot/plot_parts.hpp"
#include "app/session/wording/numbers.hpp"
#include "render/fonts/math_alphabets.hpp"

namespace jw::panels {

namespace {

constexpr float kWidestName = 0.3F;  // part of the width of the box; wider names are shortened
constexpr float kShortName = 56.0F;  // width of a name with very little room
constexpr float kNameGap = 14.0F;    // from the end of a curve to its name

struct End {
    int series = 0;
    Point at;
};

Point pixel_of(const PlotLayout& layout, const PlotPane& pane, const SeriesSet& set, int series, int point) {
    const float y = pane.y.pixel(value_at(set, series, point));
    return {
        layout.x.pixel(set.at[static_cast<std::size_t>(point)]),
        std::clamp(y, pane.plot.y, pane.plot.bottom())};
}

/// Shortens a name in the middle, because names differ at both ends: "coupler.r_dot.x" becomes "coup…ot.x".
std::string shortened_within(const ImFont& font, const std::string& name, float width) {
    std::u32string points = from_utf8(name);
    std::string text = name;
    while (points.size() > 2 && text_width(font, text) > width) {
        points.erase(points.size() / 2, 1);
        const std::size_t half = points.size() / 2;
        text = render::to_utf8(points.substr(0, half)) + "…" + render::to_utf8(points.substr(half));
    }
    return text;
}

std::string shown_value(const Series& series, double value) {
    return std::abs(value) <= series.rounding ? "0" : number_text(value);
}

/// The first `most` of `ends`, always including the highlighted one, from top to bottom.
std::vector<End> from_top(std::vector<End> ends, std::size_t most, int hovered) {
    const auto out = std::ranges::find(ends, hovered, &End::series);
    if (out != ends.end()) { std::rotate(ends.begin(), out, out + 1); }
    if (ends.size() > most) { ends.resize(most); }
    std::ranges::stable_sort(ends, {}, [](const End& end) { return end.at.y; });
    return ends;
}

/// Lines of text beside the points that they name, one below the other.
std::vector<PlotLabel> column_of_labels(
    const Canvas& canvas, const std::vector<End>& ends, const Box& column, auto&& text_of) {
    const ImFont* const small = canvas.fonts().small;
    const float line = canvas.line_height(small);
    std::vector<float> wished;
    for (const End& end : ends) { wished.push_back(end.at.y - 0.5F * line); }
    const std::vector<float> tops = spread_lines(std::move(wished), line, column.y, column.bottom());
    std::vector<PlotLabel> labels;
    for (std::size_t k = 0; k < ends.size(); ++k) {
        const std::string text =
            shortened_within(*small, text_of(ends[k].series), column.width - name_indent(canvas));
        const float width = name_indent(canvas) + canvas.text_width(small, text);
        labels.push_back({ends[k].series, text, {column.x, std::round(tops[k]), width, line}, ends[k].at});
    }
    return labels;
}

/// Column for names beside a plot. It is a little higher: a name may extend beyond the plot by half a line.
Box column_beside(const Canvas& canvas, const PlotPane& pane, float left, float width) {
    const float half = 0.5F * canvas.line_height(canvas.fonts().small);
    return {left, pane.plot.y - half, width, pane.plot.height + 2.0F * half};
}

std::size_t lines_in(const Canvas& canvas, const Box& column) {
    return static_cast<std::size_t>(column.height / canvas.line_height(canvas.fonts().small));
}

bool runs_through(const std::vector<Point>& run, const Box& box) {
    if (run.size() == 1) { return box.contains(run.front()); }
    for (std::size_t k = 1; k < run.size(); ++k) {
        if (clipped(run[k - 1], run[k], box)) { return true; }
    }
    return false;
}

/// Places for a name around the end of a curve, the best one first.
std::array<Point, 6> corners_around(Point at, float width, float line, float gap) {
    return {{
        {at.x + gap, at.y - 0.5F * line},
        {at.x + gap, at.y - 1.3F * line},
        {at.x - 0.5F * width, at.y - line - gap},
        {at.x - 0.5F * width, at.y + gap},
        {at.x - width - gap, at.y - 0.5F * line},
        {at.x - width - gap, at.y + gap},
    }};
}

/// Places the name of a curve that ends before the right edge: near its end, where no curve and no
/// other name is. Shortens the name if it has no room as a whole.
void place_within(
    const Canvas& canvas, const PlotLayout& layout, const SeriesSet& set, const End& end,
    const std::vector<std::vector<Point>>& curves, PlotPane& pane) {
    const ImFont* const small = canvas.fonts().small;
    const std::string& name = set.series[static_cast<std::size_t>(end.series)].name;
    const float line = canvas.line_height(small);
    const Box room{pane.plot.x, pane.plot.y, layout.box.right() - pane.plot.x, pane.plot.height};
    const auto is_free = [&](const Box& box) {
        return room.contains(box) &&
               std::ranges::none_of(pane.labels, [&](const PlotLabel& l) { return overlap(l.box, box); }) &&
               std::ranges::none_of(curves, [&](const auto& run) { return runs_through(run, box); });
    };
    for (const std::string& text : {name, shortened_within(*small, name, canvas.px(kShortName))}) {
        const float width = name_indent(canvas) + canvas.text_width(small, text);
        for (const Point corner : corners_around(end.at, width, line, canvas.px(7.0F))) {
            const Box box{std::round(corner.x), std::round(corner.y), width, line};
            if (!is_free(box)) { continue; }
            pane.labels.push_back({end.series, text, box, end.at});
            return;
        }
    }
    ++pane.unnamed;
}

/// Places the name of the only curve in the line above it, before the unit.
void place_title(const Canvas& canvas, const PlotLayout& layout, const SeriesSet& set, PlotPane& pane) {
    const ImFont* const small = canvas.fonts().small;
    const int series = pane.series.front();
    const float room = layout.box.right() - pane.caption_at.x - name_indent(canvas) - canvas.px(10.0F) -
                       canvas.text_width(small, pane.caption);
    const std::string text =
        shortened_within(*small, set.series[static_cast<std::size_t>(series)].name, room);
    const Box box{
        pane.caption_at.x, pane.caption_at.y, name_indent(canvas) + canvas.text_width(small, text),
        canvas.line_height(small)};
    pane.labels.push_back({series, text, box, {box.x, box.y}});
    pane.caption_at.x = box.right() + canvas.px(10.0F);
}

void place_values(
    const Canvas& canvas, const PlotLayout& layout, const SeriesSet& set, const PlotState& state,
    PlotPane& pane) {
    if (!layout.cursor) { return; }
    std::vector<End> ends;
    float width = 0.0F;
    const auto text_of = [&](int s) {
        return shown_value(set.series[static_cast<std::size_t>(s)], value_at(set, s, state.cursor));
    };
    for (const int s : pane.series) {
        const double value = value_at(set, s, state.cursor);
        const float y = pane.y.pixel(value);
        if (!std::isfinite(value) || y < pane.plot.y - 1.0F || y > pane.plot.bottom() + 1.0F) { continue; }
        ends.push_back({s, {*layout.cursor, y}});
        width = std::max(width, canvas.text_width(canvas.fonts().small, with_minus_signs(text_of(s))));
    }
    width += name_indent(canvas) + 1.0F;
    const float gap = canvas.px(8.0F);
    const bool right = *layout.cursor + gap + width <= layout.panes.front().plot.right();
    const float left = *layout.cursor + (right ? gap : -gap - width);
    Box column{left, pane.plot.y, width, pane.plot.height};
    ends = from_top(std::move(ends), lines_in(canvas, column), state.hovered);
    pane.values = column_of_labels(canvas, ends, column, text_of);
    std::erase_if(pane.labels, [&](const PlotLabel& label) {
        const auto covers = [&](const PlotLabel& value) { return overlap(value.box, label.box); };
        return std::ranges::any_of(pane.values, covers);
    });
}

}  // namespace

int last_point_of(const SeriesSet& set, int series, const PointSpan& span) {
    int last = span.last;
    while (last >= span.first && !std::isfinite(value_at(set, series, last))) { --last; }
    return last >= span.first ? last : -1;
}

float name_indent(const Canvas& canvas) { return canvas.px(14.0F); }

float mark_indent(const Canvas& canvas) { return canvas.px(5.0F); }

float name_column_width(
    const Canvas& canvas, const Box& box, const SeriesSet& set, const std::vector<int>& series,
    const PointSpan& span) {
    float widest = 0.0F;
    for (const int s : series) {
        if (span.last < 0 || last_point_of(set, s, span) != span.last) { continue; }
        const std::string& name = set.series[static_cast<std::size_t>(s)].name;
        widest = std::max(widest, canvas.text_width(canvas.fonts().small, name));
    }
    widest = std::min(widest, kWidestName * box.width);
    return widest == 0.0F ? 0.0F : widest + name_indent(canvas) + canvas.px(kNameGap);
}

std::vector<float> spread_lines(std::vector<float> wished, float height, float top, float bottom) {
    // after subtraction of the line heights, the tops only have to ascend. The nearest ascending sequence is
    // found by averaging neighbours that are in the wrong order
    struct Neighbours {
        double sum = 0.0;
        int count = 0;
        double mean() const { return sum / count; }
    };
    std::vector<Neighbours> blocks;
    for (std::size_t k = 0; k < wished.size(); ++k) {
        blocks.push_back({static_cast<double>(wished[k]) - static_cast<double>(k) * height, 1});
        while (blocks.size() > 1 && blocks.back().mean() < blocks[blocks.size() - 2].mean()) {
            const Neighbours last = blocks.back();
            blocks.pop_back();
            blocks.back().sum += last.sum;
            blocks.back().count += last.count;
        }
    }
    const double highest = static_cast<double>(bottom) - static_cast<double>(wished.size()) * height;
    std::size_t k = 0;
    for (const Neighbours& block : blocks) {
        const double base = std::max<double>(top, std::min(block.mean(), highest));
        for (int n = 0; n < block.count; ++n, ++k) {
            wished[k] = static_cast<float>(base + static_cast<double>(k) * height);
        }
    }
    return wished;
}

void place_labels(
    const Canvas& canvas, const PlotLayout& layout, const SeriesSet& set, const PlotState& state,
    const PointSpan& span, PlotPane& pane) {
    if (pane.titled) {
        place_title(canvas, layout, set, pane);
        place_values(canvas, layout, set, state, pane);
        return;
    }
    std::vector<End> at_edge;
    std::vector<End> within;
    for (const int s : pane.series) {
        const int last = last_point_of(set, s, span);
        if (last < 0) { continue; }
        (last == span.last ? at_edge : within).push_back({s, pixel_of(layout, pane, set, s, last)});
    }
    const auto name_of = [&](int s) { return set.series[static_cast<std::size_t>(s)].name; };
    const float left = pane.plot.right() + canvas.px(kNameGap);
    const Box column = column_beside(canvas, pane, left, layout.box.right() - left);
    const std::vector<End> named = from_top(at_edge, lines_in(canvas, column), state.hovered);
    pane.unnamed = static_cast<int>(at_edge.size() - named.size());
    pane.labels = column_of_labels(canvas, named, column, name_of);
    if (!within.empty()) {
        std::vector<std::vector<Point>> curves;
        for (const int s : pane.series) {
            for (auto& run : curve_of(layout, pane, set, s)) { curves.push_back(std::move(run)); }
        }
        // the highlighted curve gets its name first
        std::ranges::stable_partition(within, [&](const End& end) { return end.series == state.hovered; });
        for (const End& end : within) { place_within(canvas, layout, set, end, curves, pane); }
    }
    place_values(canvas, layout, set, state, pane);
}

}  // namespace jw::panels
