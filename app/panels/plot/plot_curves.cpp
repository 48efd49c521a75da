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

const PlotPane* pane_at(const PlotLayout& layout, Point pixel) {
    const auto found =
        std::ranges::find_if(layout.panes, [&](const PlotPane& pane) { return pane.plot.contains(pixel); });
    return found == layout.panes.end() ? nullptr : &*found;
}

void set_height(PlotState& state, const std::string& unit, const Range& range) {
    const auto found = std::ranges::find(state.heights, unit, &PlotState::Height::unit);
    if (found == state.heights.end()) {
        state.heights.push_back({unit, range});
    } else {
        found->range = range;
    }
}

/// True unless a range is too large, or so short that the numbers of the axis could not be distinguished.
bool is_sound(const Range& range) {
    const double size = std::max(std::abs(range.from), std::abs(range.to));
    return std::isfinite(range.from) && std::isfinite(range.to) && range.length() > 1e-9 * size &&
           size < 1e300;
}

/// Range between two pixels of an axis, if it is usable; else the range of the axis.
Range between(const Axis& axis, float from, float to) {
    const double a = axis.value(from);
    const double b = axis.value(to);
    const Range range{std::min(a, b), std::max(a, b)};
    return is_sound(range) ? range : axis.range;
}

}  // namespace

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

std::optional<double> at_of_pixel(const PlotLayout& layout, Point pixel) {
    if (pane_at(layout, pixel) == nullptr) { return std::nullopt; }
    return layout.x.value(pixel.x);
}

int point_near(const SeriesSet& set, double at) {
    if (set.at.empty()) { return -1; }
    const auto above = std::ranges::lower_bound(set.at, at);
    if (above == set.at.begin()) { return 0; }
    const auto k = static_cast<int>(above - set.at.begin());
    if (above == set.at.end()) { return k - 1; }
    return at - *(above - 1) < *above - at ? k - 1 : k;
}

int point_of_step(const SeriesSet& set, int step) {
    const auto above = std::ranges::upper_bound(set.steps, step);
    return static_cast<int>(above - set.steps.begin()) - 1;
}

std::optional<PlotHit> hit_of(const PlotLayout& layout, const SeriesSet& set, Point pixel, float reach) {
    const PlotPane* const pane = pane_at(layout, pixel);
    if (pane == nullptr) { return std::nullopt; }
    const PointSpan span =
        visible_points(set, {layout.x.value(pixel.x - reach), layout.x.value(pixel.x + reach)});
    std::optional<PlotHit> best;
    for (const int s : pane->series) {
        for (int k = span.first; k <= span.last; ++k) {
            const double value = value_at(set, s, k);
            if (!std::isfinite(value)) { continue; }
            const float x = layout.x.pixel(set.at[static_cast<std::size_t>(k)]);
            const float distance = std::hypot(x - pixel.x, pane->y.pixel(value) - pixel.y);
            if (distance <= (best ? best->distance : reach)) { best = PlotHit{s, k, distance}; }
        }
    }
    return best;
}

PlotState zoomed(PlotState state, const PlotLayout& layout, Point about, double factor) {
    const PlotPane* const pane = pane_at(layout, about);
    if (pane == nullptr || !(factor > 0.0)) { return state; }
    const auto scale = static_cast<float>(1.0 / factor);
    const auto nearer = [scale](const Axis& axis, float middle) {
        return between(axis, middle + scale * (axis.start - middle), middle + scale * (axis.end - middle));
    };
    state.window = nearer(layout.x, about.x);
    set_height(state, pane->unit, nearer(pane->y, about.y));
    return state;
}

PlotState panned(PlotState state, const PlotLayout& layout, Point at, Point by) {
    const PlotPane* const pane = pane_at(layout, at);
    if (pane == nullptr) { return state; }
    state.window = between(layout.x, layout.x.start - by.x, layout.x.end - by.x);
    set_height(state, pane->unit, between(pane->y, pane->y.start - by.y, pane->y.end - by.y));
    return state;
}

PlotState unzoomed(PlotState state) {
    state.window.reset();
    state.heights.clear();
    return state;
}

}  // namespace jw::panels
