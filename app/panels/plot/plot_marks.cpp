#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "app/panels/parts/text.hpp"
#include "app/panels/plot/plot_parts.hpp"

namespace jw::panels {

namespace {

constexpr float kHighBox = 18.0F;    // in lines: has room for a second row
constexpr float kCrowded = 0.6F;     // of the width, taken by names
constexpr float kGapOfNames = 8.0F;  // between names

/// The lowest row in which `mark` has room between those that are placed.
bool find_place(const Canvas& canvas, const Box& strip, int rows, std::vector<Box>& placed, PlotMark& mark) {
    const ImFont* const small = canvas.fonts().small;
    const float line = canvas.line_height(small);
    mark.text = shortened(*small, mark.text, strip.width);
    const float width = canvas.text_width(small, mark.text);
    const float left = std::clamp(mark.x - 0.5F * width, strip.x, strip.right() - width);
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
    // all texts in full, or all of them brief
    for (const bool brief : {false, true}) {
        layout.marks.clear();
        for (const Mark& mark : set.marks) {
            if (!layout.x.range.contains(mark.at)) { continue; }
            const std::string& text = brief && !mark.brief.empty() ? mark.brief : mark.text;
            layout.marks.push_back({layout.x.pixel(mark.at), text, {}});
        }
        std::vector<PlotMark*> order;
        for (PlotMark& mark : layout.marks) { order.push_back(&mark); }
        if (layout.cursor) {
            // the one that the cursor stands at has its name in any case
            std::ranges::stable_sort(
                order, {}, [&](const PlotMark* mark) { return std::abs(mark->x - *layout.cursor); });
        }
        std::vector<Box> placed;
        bool all = true;
        for (PlotMark* const mark : order) { all = find_place(canvas, strip, rows, placed, *mark) && all; }
        if (all) { return; }
    }
}

}  // namespace jw::panels
