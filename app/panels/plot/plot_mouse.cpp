#include <algorithm>
#include <cmath>

#include "app/panels/plot/plot_parts.hpp"

namespace jw::panels {

namespace {

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
