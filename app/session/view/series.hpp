#pragma once

#include <string>
#include <vector>

#include "app/session/story/story.hpp"
#include "core/quantity/names.hpp"

/// Curves of a story as plain values: quantities and singular values over time, residuals over iterations. A
/// set is computed once per story, and not updated.
namespace jw {

struct Series {
    std::string name;            ///< "crank.angle", "coupler.r_dot.x", "|coupler.omega|", "crank.angle_dot"
    std::string unit;            ///< "deg", "m/s", ...; "-" if it has none
    std::vector<double> values;  ///< one per point of the set; NaN where there is none
    double rounding = 0.0;       ///< differences up to this size are rounding
    bool limit = false;          ///< a bound to compare with, not a quantity
};

/// Something that happened at one moment.
struct Mark {
    double at = 0.0;      ///< on the axis of the set
    std::string text;     ///< short: "sleeve p1: x is left out"
    std::string brief{};  ///< if there is no room for that: "sleeve switches"; empty: there is no shorter one
    std::string many{};   ///< name of several of them if there is no room for each: "switches"; empty: none
};

struct SeriesSet {
    std::string axis;        ///< "t [s]" or "iteration"
    std::vector<double> at;  ///< ascending
    std::vector<int> steps;  ///< the story's step that each point belongs to, or the next one after it
    bool of_curve = false;   ///< the points are the moments of Story::curve
    std::vector<Series> series;
    std::vector<int> telling;  ///< indices of the series that are shown first
    bool logarithmic = false;  ///< values are best seen on a logarithmic scale
    std::vector<Mark> marks;
    std::string why_empty;  ///< one sentence if there are no points
};

/// Measures of drivers and joints with rate and acceleration; for every moving body r, ṙ, r̈, ω, ω̇ (global
/// components and magnitudes); position and speed of the point that is `traced` (body -1: none); for a motion
/// by masses and forces its energies. Angles are continuous over turns.
SeriesSet motion_series(const Story& story, const BodyPoint& traced = {.body = -1});

/// Adds curves of more quantities to a set over time; those that it has already stay as they are.
/// @return number of curves added
int add_series(SeriesSet& set, const Story& story, const std::vector<NamedQuantity>& list);

/// ‖Φ‖ over the Newton iterations of the whole story, one after the other; one series per joint or driver.
SeriesSet newton_series(const Story& story);

/// Singular values of the (r, ω′) matrix over the motion, and the threshold below which they count as zero.
/// This needs one decomposition per moment, so the result should be kept.
SeriesSet singular_value_series(const Story& story);

/// Condition numbers of the two rows that are left of each p1 and p2 of `joint` when x, y or z is left out,
/// and of the rows in use. NaN where a pair has lost rank. Empty if the joint has no such equations.
SeriesSet condition_series(const Story& story, int joint);

/// Directions of the axis s_i of `joint` over the story from the step in which it is added up to step `last`,
/// global, unit; empty before that.
std::vector<Vec3> axis_directions(const Story& story, int joint, int last);

/// CSV of a set (RFC 4180 with line feeds): a header with units, then one line per point; numbers in the
/// shortest form that reads back as the same double, empty where there is none.
std::string csv_of(const SeriesSet& set);

}  // namespace jw
