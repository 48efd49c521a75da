#pragma once

#include <array>
#include <optional>

#include "app/panels/plot/plot.hpp"

/// Parts shared by the files of the plot; only for them and their tests.
namespace jw::panels {

/// First and last point of the set within the window of the axis; first > last if there are none.
struct PointSpan {
    int first = 0;
    int last = -1;
};
PointSpan visible_points(const SeriesSet& set, const Range& window);

inline double value_at(const SeriesSet& set, int series, int point) {
    return set.series[static_cast<std::size_t>(series)].values[static_cast<std::size_t>(point)];
}

/// Last visible point that has a value; -1 if there is none.
int last_point_of(const SeriesSet& set, int series, const PointSpan& span);

/// Distances from the left edge of a curve's name to its text, and to the middle of the mark before it.
float name_indent(const Canvas& canvas);
float mark_indent(const Canvas& canvas);
/// Width of the names of the curves that end at the right edge; 0 if none does.
float name_column_width(
    const Canvas& canvas, const Box& box, const SeriesSet& set, const std::vector<int>& series,
    const PointSpan& span);

/// Tops of lines of equal height between `top` and `bottom`, without overlaps and as near as possible to the
/// wished tops, which ascend. All lines must have room.
std::vector<float> spread_lines(std::vector<float> wished, float height, float top, float bottom);

/// Number of lines above the curves for the texts of marks: two if one would be crowded.
int rows_of_marks(const Canvas& canvas, const Box& box, const SeriesSet& set);
/// Places the marks; the axis and the cursor must have their places.
void place_marks(const Canvas& canvas, const SeriesSet& set, int rows, PlotLayout& layout);

/// Places names at the ends of curves and, if there is a cursor, the values at it.
void place_labels(
    const Canvas& canvas, const PlotLayout& layout, const SeriesSet& set, const PlotState& state,
    const PointSpan& span, PlotPane& pane);

/// Style of a curve, from its place among the curves. Colour, dashes and marks repeat with different periods,
/// so that curves can be distinguished.
struct CurveStyle {
    Colour colour;
    int dashes = 0;
    int mark = 0;
    float width = 1.8F;  ///< at 720
    bool marked = true;
};
CurveStyle style_of(const PlotPane& pane, std::size_t place, const SeriesSet& set, const PlotState& state);

void draw_curve(
    const Canvas& canvas, const Box& clip, const std::vector<Point>& points, const CurveStyle& style);
void draw_curve_mark(const Canvas& canvas, Point at, const CurveStyle& style);

}  // namespace jw::panels
