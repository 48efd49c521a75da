#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "app/panels/parts/text_lines.hpp"
#include "app/panels/plot/plot_parts.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"

namespace jw::panels {

namespace {

constexpr float kTickLength = 4.0F;
constexpr float kNumberGap = 4.0F;     // between a number and its tick
constexpr float kLeastPane = 3.2F;     // height of the smallest useful plot, in lines
constexpr float kTickDistance = 2.1F;  // between numbers of a vertical axis, in lines
constexpr float kTickWidth = 66.0F;    // room for a number of the lower axis
constexpr float kLongName = 0.22F;     // part of the width: a single curve has a longer name above it

bool is_time(const SeriesSet& set) { return set.axis.find('[') != std::string::npos; }

/// A unit such as "deg/s²" as it is written in a picture.
std::string shown_unit(const std::string& unit) {
    if (unit == "-") { return {}; }
    return unit.starts_with("deg") ? "°" + unit.substr(3) : unit;
}

std::string caption_of(const std::string& unit, int exponent) {
    const std::string shown = shown_unit(unit);
    if (exponent == 0) { return shown.empty() ? std::string() : tr("in {0}", shown); }
    return tr("in {0}", power_of_ten(exponent) + (shown.empty() ? "" : " " + shown));
}

/// Height above the curves of a pane: for its caption, or only for half a number.
float caption_height(const Canvas& canvas, const PlotPane& pane) {
    const float line = canvas.line_height(canvas.fonts().small);
    return pane.unit == "-" && !pane.titled ? 0.6F * line : line + canvas.px(3.0F);
}

std::vector<PlotPane> panes_of(const SeriesSet& set, const std::vector<int>& shown) {
    std::vector<PlotPane> panes;
    for (const int s : shown) {
        const std::string& unit = set.series[static_cast<std::size_t>(s)].unit;
        auto pane = std::ranges::find(panes, unit, &PlotPane::unit);
        if (pane == panes.end()) {
            panes.emplace_back();
            panes.back().unit = unit;
            pane = panes.end() - 1;
        }
        pane->series.push_back(s);
    }
    return panes;
}

/// True if a logarithmic axis has values of zero or below, for which it has no place.
bool has_zeros(const SeriesSet& set, const PlotPane& pane, const PointSpan& span) {
    if (!set.logarithmic) { return false; }
    for (const int s : pane.series) {
        for (int k = span.first; k <= span.last; ++k) {
            if (value_at(set, s, k) <= 0.0) { return true; }
        }
    }
    return false;
}

/// Range of the visible values; nothing if there are none.
std::optional<Range> range_of(const SeriesSet& set, const PlotPane& pane, const PointSpan& span) {
    Range found{HUGE_VAL, -HUGE_VAL};
    double rounding = 0.0;
    for (const int s : pane.series) {
        rounding = std::max(rounding, set.series[static_cast<std::size_t>(s)].rounding);
        for (int k = span.first; k <= span.last; ++k) {
            const double value = value_at(set, s, k);
            if (!std::isfinite(value) || (set.logarithmic && value <= 0.0)) { continue; }
            found.from = std::min(found.from, value);
            found.to = std::max(found.to, value);
        }
    }
    const bool zeros = has_zeros(set, pane, span);
    if (found.from > found.to) { return zeros ? std::optional<Range>({1e-16, 1.0}) : std::nullopt; }
    if (!set.logarithmic) { return range_around(found, rounding); }
    if (zeros) { found.from *= 0.1; }
    return log_range_around(found);
}

void set_values_axis(
    const Canvas& canvas, const SeriesSet& set, const PlotState& state, const PointSpan& span,
    PlotPane& pane) {
    pane.y.logarithmic = set.logarithmic;
    pane.y.range = range_of(set, pane, span).value_or(set.logarithmic ? Range{0.1, 10.0} : Range{0.0, 1.0});
    const auto zoomed = std::ranges::find(state.heights, pane.unit, &PlotState::Height::unit);
    if (zoomed != state.heights.end()) { pane.y.range = zoomed->range; }
    pane.y.start = pane.plot.bottom();
    pane.y.end = pane.plot.y;
    const float line = canvas.line_height(canvas.fonts().small);
    const int most = static_cast<int>(pane.plot.height / (kTickDistance * line));
    pane.ticks = ticks_of(pane.y, std::max(2, most), pane.unit == "deg" ? Ticks::degrees : Ticks::decimal);
    // zeros are at the lower end of a logarithmic axis, which is labelled 0
    const bool room =
        pane.ticks.ticks.empty() || pane.y.start - pane.y.pixel(pane.ticks.ticks.front().at) > 0.9F * line;
    if (has_zeros(set, pane, span) && room) {
        pane.ticks.ticks.insert(pane.ticks.ticks.begin(), {pane.y.range.from, "0"});
    }
    pane.caption = caption_of(pane.unit, pane.ticks.exponent);
}

bool has_long_name(const Canvas& canvas, const Box& box, const SeriesSet& set, const PlotPane& pane) {
    if (pane.series.size() != 1) { return false; }
    const Series& only = set.series[static_cast<std::size_t>(pane.series.front())];
    return canvas.text_width(canvas.fonts().small, only.name) > kLongName * box.width;
}

/// Stacks panes in `rest`, at whose foot the curves end. Panes without room are left out.
void stack_panes(const Canvas& canvas, Box rest, PlotLayout& layout) {
    const float line = canvas.line_height(canvas.fonts().small);
    const float least = (kLeastPane + 1.0F) * line;
    const auto most = static_cast<std::size_t>(std::max(1.0F, rest.height / least));
    if (layout.panes.size() > most) {
        layout.left_out = static_cast<int>(layout.panes.size() - most);
        layout.panes.resize(most);
    }
    const float height = rest.height / static_cast<float>(layout.panes.size());
    for (PlotPane& pane : layout.panes) {
        Box part = cut_top(rest, height);
        pane.caption_at.y = part.y;
        cut_top(part, caption_height(canvas, pane));
        pane.plot = {std::round(part.x), std::round(part.y), part.width, std::floor(part.height)};
    }
}

void set_lower_axis(const Canvas& canvas, const SeriesSet& set, PlotLayout& layout) {
    const ImFont* const small = canvas.fonts().small;
    const Box& plot = layout.panes.back().plot;
    layout.x.start = plot.x;
    layout.x.end = plot.right();
    const int most = static_cast<int>(plot.width / canvas.px(kTickWidth));
    layout.ticks = ticks_of(layout.x, most, is_time(set) ? Ticks::decimal : Ticks::whole);
    layout.axis = tr(set.axis.c_str());
    if (layout.ticks.exponent != 0) { layout.axis += " · " + power_of_ten(layout.ticks.exponent); }
    const float width = canvas.text_width(small, layout.axis);
    const float top = plot.bottom() + canvas.px(kTickLength + 2.0F);
    layout.axis_box = {layout.box.right() - width, top, width, canvas.line_height(small)};
}

void place_cursor(const Canvas& canvas, const SeriesSet& set, const PlotState& state, PlotLayout& layout) {
    if (state.cursor < 0 || state.cursor >= static_cast<int>(set.at.size())) { return; }
    const double at = set.at[static_cast<std::size_t>(state.cursor)];
    if (!layout.x.range.contains(at)) { return; }
    const ImFont* const small = canvas.fonts().small;
    layout.cursor = std::round(layout.x.pixel(at));
    layout.cursor_text = number_text(at) + (set.axis == "t [s]" ? " s" : "");
    const float width = canvas.text_width(small, layout.cursor_text) + canvas.px(10.0F);
    const float left = std::clamp(*layout.cursor - 0.5F * width, layout.box.x, layout.box.right() - width);
    layout.cursor_box = {std::round(left), layout.axis_box.y, width, layout.axis_box.height};
}

Range window_of(const SeriesSet& set, const PlotState& state) {
    if (state.window) { return *state.window; }
    const double from = set.at.front();
    const double to = set.at.back();
    if (to > from) { return {from, to}; }
    return {from - 0.5, from + 0.5};  // a single point is in the middle
}

constexpr float kHighBox = 18.0F;    // in lines: a higher box has room for a second row
constexpr float kCrowded = 0.6F;     // part of the width that texts may take in one row
constexpr float kGapOfNames = 8.0F;  // between names
constexpr float kCloseMarks = 16.0F;
constexpr std::size_t kFewestInStretch = 4;

/// Number of marks, from `first` on, that would hide the curves: marks of one kind, each close to the next.
std::size_t crowd_from(
    const Canvas& canvas, const PlotLayout& layout, const std::vector<Mark>& marks, std::size_t first) {
    std::size_t next = first + 1;
    if (marks[first].many.empty()) { return 1; }
    const float close = canvas.px(kCloseMarks);
    while (next < marks.size() && marks[next].many == marks[first].many &&
           layout.x.pixel(marks[next].at) - layout.x.pixel(marks[next - 1].at) < close) {
        ++next;
    }
    return next - first >= kFewestInStretch ? next - first : 1;
}

/// The visible marks. Many marks of a kind that are close together become one stretch.
std::vector<PlotMark> thinned_out(
    const Canvas& canvas, const PlotLayout& layout, const SeriesSet& set, bool brief) {
    std::vector<Mark> seen;
    for (const Mark& mark : set.marks) {
        if (layout.x.range.contains(mark.at)) { seen.push_back(mark); }
    }
    std::vector<PlotMark> marks;
    for (std::size_t k = 0; k < seen.size();) {
        const std::size_t count = crowd_from(canvas, layout, seen, k);
        const Mark& first = seen[k];
        PlotMark mark{layout.x.pixel(first.at), brief && !first.brief.empty() ? first.brief : first.text, {}};
        mark.end = layout.x.pixel(seen[k + count - 1].at);
        mark.count = static_cast<int>(count);
        if (count > 1) { mark.text = tr("{0} {1}", count, first.many); }
        marks.push_back(std::move(mark));
        k += count;
    }
    return marks;
}

/// Places `mark` in the lowest row in which it has room between the placed ones. @return false if none has
bool find_place(const Canvas& canvas, const Box& strip, int rows, std::vector<Box>& placed, PlotMark& mark) {
    const ImFont* const small = canvas.fonts().small;
    const float line = canvas.line_height(small);
    mark.text = shortened(*small, mark.text, strip.width);
    const float width = canvas.text_width(small, mark.text);
    const float left = std::clamp(0.5F * (mark.x + mark.end) - 0.5F * width, strip.x, strip.right() - width);
    for (int row = rows - 1; row >= 0; --row) {
        mark.box = {std::round(left), strip.y + static_cast<float>(row) * line, width, line};
        const Box roomy = shrunk(mark.box, -0.5F * canvas.px(kGapOfNames), 0.0F);
        if (std::ranges::any_of(placed, [&](const Box& b) { return overlap(b, roomy); })) { continue; }
        placed.push_back(roomy);
        return true;
    }
    mark.text.clear();
    mark.box = {};
    return false;
}

}  // namespace

std::vector<int> shown_series(const SeriesSet& set, const PlotState& state) {
    std::vector<int> shown = state.shown.empty() ? set.telling : state.shown;
    const int count = static_cast<int>(set.series.size());
    std::erase_if(shown, [count](int s) { return s < 0 || s >= count; });
    return shown;
}

PointSpan visible_points(const SeriesSet& set, const Range& window) {
    const auto first = std::ranges::lower_bound(set.at, window.from);
    const auto last = std::ranges::upper_bound(set.at, window.to);
    return {static_cast<int>(first - set.at.begin()), static_cast<int>(last - set.at.begin()) - 1};
}

PlotLayout layout_plot(const Canvas& canvas, const Box& box, const SeriesSet& set, const PlotState& state) {
    PlotLayout layout;
    layout.box = box;
    layout.panes = panes_of(set, shown_series(set, state));
    if (set.at.empty() || layout.panes.empty()) {
        layout.panes.clear();
        layout.empty = set.at.empty() ? set.why_empty : tr("No curve is chosen.");
        return layout;
    }
    const ImFont* const small = canvas.fonts().small;
    const float line = canvas.line_height(small);
    const Range window = window_of(set, state);
    const PointSpan span = visible_points(set, window);
    layout.x.range = window;

    // heights first: they determine how many numbers an axis has, and so how wide these are
    const int rows = rows_of_marks(canvas, box, set);
    for (PlotPane& pane : layout.panes) { pane.titled = has_long_name(canvas, box, set, pane); }
    Box rest = box;
    cut_top(rest, static_cast<float>(rows) * line);
    rest.height -= line + canvas.px(kTickLength + 2.0F);
    stack_panes(canvas, rest, layout);
    float left = 0.0F;
    std::vector<int> drawn;
    for (PlotPane& pane : layout.panes) {
        set_values_axis(canvas, set, state, span, pane);
        for (const Tick& tick : pane.ticks.ticks) {
            left = std::max(left, canvas.text_width(small, with_minus_signs(tick.text)));
        }
        if (!pane.titled) { drawn.insert(drawn.end(), pane.series.begin(), pane.series.end()); }
    }
    left = std::round(box.x + left + canvas.px(kTickLength + kNumberGap));
    const float names = name_column_width(canvas, box, set, drawn, span);
    const float right = std::floor(box.right() - std::max(names, canvas.px(10.0F)));
    for (PlotPane& pane : layout.panes) {
        pane.plot.x = pane.caption_at.x = left;
        pane.plot.width = std::max(1.0F, right - left);
    }
    set_lower_axis(canvas, set, layout);
    place_cursor(canvas, set, state, layout);
    place_marks(canvas, set, rows, layout);
    for (PlotPane& pane : layout.panes) { place_labels(canvas, layout, set, state, span, pane); }
    return layout;
}

int rows_of_marks(const Canvas& canvas, const Box& box, const SeriesSet& set) {
    if (set.marks.empty()) { return 0; }
    const ImFont* const small = canvas.fonts().small;
    float width = 0.0F;
    for (const Mark& mark : set.marks) { width += canvas.text_width(small, mark.text); }
    const bool high = box.height > kHighBox * canvas.line_height(small);
    return high && width > kCrowded * box.width ? 2 : 1;
}

void place_marks(const Canvas& canvas, const SeriesSet& set, int rows, PlotLayout& layout) {
    const Box& plot = layout.panes.front().plot;
    const Box strip{plot.x, layout.box.y, plot.width, 0.0F};
    // all texts in full, or all of them in their brief form
    for (const bool brief : {false, true}) {
        layout.marks = thinned_out(canvas, layout, set, brief);
        std::vector<PlotMark*> order;
        for (PlotMark& mark : layout.marks) { order.push_back(&mark); }
        if (layout.cursor) {
            // the mark at the cursor always has its text
            std::ranges::stable_sort(order, {}, [&](const PlotMark* mark) {
                return std::max({mark->x - *layout.cursor, *layout.cursor - mark->end, 0.0F});
            });
        }
        std::vector<Box> placed;
        bool all = true;
        for (PlotMark* const mark : order) { all = find_place(canvas, strip, rows, placed, *mark) && all; }
        if (all) { return; }
    }
}

}  // namespace jw::panels
