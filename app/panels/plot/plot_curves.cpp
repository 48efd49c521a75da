#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "app/panels/parts/theme.hpp"
#include "app/panels/plot/plot_parts.hpp"

namespace jw::panels {

namespace {

/// Colours that are dark enough for a thin line on paper; neighbours also differ in brightness.
constexpr std::array kCurveColours{theme::palette::kVectorI,  theme::palette::kVectorJ,
                                   theme::palette::kVectorD,  render::from_hex(0x8E4585),
                                   theme::palette::kInk,      render::from_hex(0x8A5A00),
                                   render::from_hex(0x3F8FC4)};

// alternating lengths of dashes and gaps, at 720; a curve without them is solid
constexpr std::array<float, 2> kDashes{8.0F, 4.0F};
constexpr std::array<float, 4> kDashDot{10.0F, 3.0F, 2.5F, 3.0F};
constexpr std::array<float, 2> kDots{2.5F, 3.0F};
constexpr std::array<float, 2> kShortDashes{4.0F, 3.0F};
constexpr std::array<std::span<const float>, 5> kPatterns{
    std::span<const float>{}, kDashes, kDashDot, kDots, kShortDashes};
constexpr int kLimitPattern = 4;

constexpr int kMarks = 6;

/// Draws along a curve with the pen alternately down and up.
class Pen {
public:
    Pen(const Canvas& canvas, const Box& clip, const CurveStyle& style)
        : canvas_(canvas),
          clip_(clip),
          pattern_(kPatterns[static_cast<std::size_t>(style.dashes)]),
          colour_(style.colour),
          width_(std::max(1.0F, style.width * canvas.fonts().scale)) {}

    void draw_to(Point from, Point to) {
        const float length = std::hypot(to.x - from.x, to.y - from.y);
        if (pattern_.empty() || length <= 0.0F) {
            line(from, to);
            return;
        }
        const auto at = [&](float part) {
            return Point{from.x + part * (to.x - from.x) / length, from.y + part * (to.y - from.y) / length};
        };
        for (float done = 0.0F; done < length;) {
            const float dash = pattern_[next_] * canvas_.fonts().scale;
            const float piece = std::min(dash - used_, length - done);
            if (next_ % 2 == 0) { line(at(done), at(done + piece)); }
            done += piece;
            used_ += piece;
            if (used_ >= dash - 1e-3F) {  // pixels
                next_ = (next_ + 1) % pattern_.size();
                used_ = 0.0F;
            }
        }
    }

private:
    void line(Point from, Point to) const {
        const auto part = clipped(from, to, clip_);
        if (!part) { return; }
        // ImGui draws lines from the centres of pixels
        const auto [a, b] = *part;
        canvas_.line({a.x - 0.5F, a.y - 0.5F}, {b.x - 0.5F, b.y - 0.5F}, colour_, width_);
    }

    const Canvas& canvas_;
    Box clip_;
    std::span<const float> pattern_;
    Colour colour_;
    float width_;
    std::size_t next_ = 0;
    float used_ = 0.0F;
};

/// Points of a curve in one column of pixels, reduced to the first, the lowest, the highest and the last.
class Column {
public:
    void add(Point p, std::vector<Point>& run) {
        const float column = std::floor(p.x);
        if (count_ > 0 && column != column_) { flush(run); }
        if (count_ == 0) { first_ = low_ = high_ = p; }
        column_ = column;
        last_ = p;
        ++count_;
        if (p.y < low_.y) { low_ = p; }
        if (p.y > high_.y) { high_ = p; }
    }
    void flush(std::vector<Point>& run) {
        if (count_ == 0) { return; }
        run.push_back(first_);
        if (count_ > 3) {
            const bool low_first = low_.x <= high_.x;
            run.push_back(low_first ? low_ : high_);
            run.push_back(low_first ? high_ : low_);
        } else if (count_ == 3) {
            const bool low = low_.y < std::min(first_.y, last_.y);
            const bool high = high_.y > std::max(first_.y, last_.y);
            if (low || high) { run.push_back(low ? low_ : high_); }
        }
        if (count_ > 1) { run.push_back(last_); }
        count_ = 0;
    }

private:
    float column_ = 0.0F;
    int count_ = 0;
    Point first_, low_, high_, last_;
};

/// Draws the outline of a figure with three or four corners.
void draw_corners(const Canvas& canvas, std::span<const Point> corners, const CurveStyle& style) {
    const float width = std::max(1.0F, 1.4F * canvas.fonts().scale);
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Point a = corners[k];
        const Point b = corners[(k + 1) % corners.size()];
        canvas.line({a.x - 0.5F, a.y - 0.5F}, {b.x - 0.5F, b.y - 0.5F}, style.colour, width);
    }
}

}  // namespace

std::optional<std::array<Point, 2>> clipped(Point a, Point b, const Box& box) {
    float enter = 0.0F;
    float leave = 1.0F;
    const float dx = b.x - a.x;
    const float dy = b.y - a.y;
    const std::array<std::array<float, 2>, 4> sides{
        {{-dx, a.x - box.x}, {dx, box.right() - a.x}, {-dy, a.y - box.y}, {dy, box.bottom() - a.y}}};
    for (const auto& [slope, room] : sides) {
        if (slope == 0.0F) {
            if (room < 0.0F) { return std::nullopt; }
        } else if (slope < 0.0F) {
            enter = std::max(enter, room / slope);
        } else {
            leave = std::min(leave, room / slope);
        }
    }
    if (enter > leave) { return std::nullopt; }
    return std::array<Point, 2>{{{a.x + enter * dx, a.y + enter * dy}, {a.x + leave * dx, a.y + leave * dy}}};
}

CurveStyle style_of(const PlotPane& pane, std::size_t place, const SeriesSet& set, const PlotState& state) {
    const int series = pane.series[place];
    CurveStyle style;
    style.colour = kCurveColours[place % kCurveColours.size()];
    style.dashes = static_cast<int>(place % kLimitPattern);
    style.mark = static_cast<int>(place % kMarks);
    if (set.series[static_cast<std::size_t>(series)].limit) {
        style = {theme::kRedundant, kLimitPattern, 0, 1.2F, false};
    }
    if (state.hovered == series) {
        style.width = 2.8F;
    } else if (std::ranges::find(pane.series, state.hovered) != pane.series.end()) {
        style.colour = render::mix(style.colour, theme::kPaper, 0.6F);
    }
    return style;
}

std::vector<std::vector<Point>> curve_of(
    const PlotLayout& layout, const PlotPane& pane, const SeriesSet& set, int series) {
    std::vector<std::vector<Point>> runs(1);
    const PointSpan span = visible_points(set, layout.x.range);
    // one more point on each side, because lines continue beyond the window
    const int first = std::max(0, span.first - 1);
    const int last = std::min(static_cast<int>(set.at.size()) - 1, span.last + 1);
    Column column;
    for (int k = first; k <= last; ++k) {
        const double value = value_at(set, series, k);
        if (std::isfinite(value)) {
            const float x = layout.x.pixel(set.at[static_cast<std::size_t>(k)]);
            column.add({x, pane.y.pixel(value)}, runs.back());
        } else {
            column.flush(runs.back());
            if (!runs.back().empty()) { runs.emplace_back(); }
        }
    }
    column.flush(runs.back());
    if (runs.back().empty()) { runs.pop_back(); }
    return runs;
}

void draw_curve(
    const Canvas& canvas, const Box& clip, const std::vector<Point>& points, const CurveStyle& style) {
    Pen pen(canvas, clip, style);
    for (std::size_t k = 1; k < points.size(); ++k) { pen.draw_to(points[k - 1], points[k]); }
}

void draw_curve_mark(const Canvas& canvas, Point at, const CurveStyle& style) {
    const float r = 3.4F * canvas.fonts().scale;
    const float width = std::max(1.0F, 1.4F * canvas.fonts().scale);
    switch (style.mark) {
        case 0: canvas.disc(at, r, style.colour); return;
        case 1: canvas.square(at, std::round(1.8F * r), style.colour, true); return;
        case 2:
            canvas.disc(at, r, theme::kPaper);
            canvas.ring(at, r, style.colour, width);
            return;
        case 3: {
            const std::array<Point, 3> corners{
                {{at.x, at.y - 1.2F * r},
                 {at.x + 1.1F * r, at.y + 0.8F * r},
                 {at.x - 1.1F * r, at.y + 0.8F * r}}};
            draw_corners(canvas, corners, style);
            return;
        }
        case 4: {
            const std::array<Point, 4> corners{
                {{at.x, at.y - 1.3F * r},
                 {at.x + 1.3F * r, at.y},
                 {at.x, at.y + 1.3F * r},
                 {at.x - 1.3F * r, at.y}}};
            draw_corners(canvas, corners, style);
            return;
        }
        default:
            canvas.line({at.x - r, at.y - r}, {at.x + r, at.y + r}, style.colour, width);
            canvas.line({at.x - r, at.y + r}, {at.x + r, at.y - r}, style.colour, width);
    }
}

}  // namespace jw::panels
