#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/panels/parts/canvas.hpp"
#include "app/panels/plot/plot_axis.hpp"
#include "app/session/view/series.hpp"

/// Plots of a SeriesSet. Layout and drawing are two steps: the layout is plain values, which the handling of
/// the mouse and tests use; drawing adds nothing to it.
namespace jw::panels {

/// Choices of the user in a plot.
struct PlotState {
    /// Visible range of the values of one unit.
    struct Height {
        std::string unit;
        Range range;
    };
    std::vector<int> shown;       ///< of the set's series; empty: SeriesSet::telling
    std::optional<Range> window;  ///< of the axis; empty: all of it
    std::vector<Height> heights;  ///< units that are zoomed; the others fit their curves
    int cursor = -1;              ///< point of the set, -1: none
    int hovered = -1;             ///< highlighted series of the set, -1: none
};

/// Name of a curve at its end, or its value at the cursor.
struct PlotLabel {
    int series = 0;
    std::string text;
    Box box;
    Point anchor;  ///< point of the curve
};

/// One mark, or a stretch of many marks whose lines would hide the curves.
struct PlotMark {
    float x = 0.0F;
    std::string text;  ///< empty if there is no room
    Box box;
    float end = 0.0F;  ///< right end of a stretch; for one mark, its x
    int count = 1;
};

/// Curves of one unit, with a vertical axis of their own.
struct PlotPane {
    std::string unit;
    std::string caption;  ///< "in 10³ m/s", above the curves
    Point caption_at;
    bool titled = false;  ///< the name of the only curve is before the caption, not at its end
    Box plot;             ///< area of the curves
    Axis y;
    TickMarks ticks;
    std::vector<int> series;
    std::vector<PlotLabel> labels;
    std::vector<PlotLabel> values;  ///< at the cursor
    int unnamed = 0;                ///< number of curves without room for their names
};

struct PlotLayout {
    Box box;
    Axis x;
    TickMarks ticks;
    std::string axis;  ///< "t [s]"
    Box axis_box;
    std::vector<PlotPane> panes;  ///< one above the other, all over the same x
    int left_out = 0;             ///< number of units without room
    std::vector<PlotMark> marks;
    std::optional<float> cursor;
    std::string cursor_text;
    Box cursor_box;
    std::string empty;  ///< message that is shown instead of the plot
};

PlotLayout layout_plot(const Canvas& canvas, const Box& box, const SeriesSet& set, const PlotState& state);
void draw_plot(const Canvas& canvas, const PlotLayout& layout, const SeriesSet& set, const PlotState& state);

/// Indices of the shown series, in the order in which they are drawn.
std::vector<int> shown_series(const SeriesSet& set, const PlotState& state);

/// The pixels of a curve, broken where it has no values; at most four per column of pixels, so that a peak
/// between two columns is still seen.
std::vector<std::vector<Point>> curve_of(
    const PlotLayout& layout, const PlotPane& pane, const SeriesSet& set, int series);

// ---- handling of the mouse ----------------------------------------------------------------------

/// Value of the axis under a pixel; empty outside of all panes.
std::optional<double> at_of_pixel(const PlotLayout& layout, Point pixel);
/// The point of the set that is nearest to `at` on the axis; -1 if there is none.
int point_near(const SeriesSet& set, double at);
/// The point of a step of the story, or the last point before it; -1 if there is none.
int point_of_step(const SeriesSet& set, int step);

struct PlotHit {
    int series = 0;
    int point = 0;
    float distance = 0.0F;  ///< [pixels]
};
/// The drawn point nearest to a pixel, no farther than `reach` pixels.
std::optional<PlotHit> hit_of(const PlotLayout& layout, const SeriesSet& set, Point pixel, float reach);

/// State after zooming by `factor` (above 1: nearer) about a pixel; it zooms the axis, and the values of the
/// pane of the pixel.
PlotState zoomed(PlotState state, const PlotLayout& layout, Point about, double factor);
/// State after moving with the mouse.
PlotState panned(PlotState state, const PlotLayout& layout, Point at, Point by);
/// State in which everything is visible again.
PlotState unzoomed(PlotState state);

}  // namespace jw::panels
