#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "app/panels/parts/text_lines.hpp"
#include "app/panels/plot/plot_parts.hpp"
#include "app/session/wording/messages.hpp"

namespace jw::panels {

namespace {

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
