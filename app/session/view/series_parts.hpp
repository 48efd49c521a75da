#pragma once

#include "app/session/view/series.hpp"

/// Common parts of the sets over time; used by series.cpp and series_of_rows.cpp only.
namespace jw::series {

/// Times and steps of the motion, with marks where rows were chosen again and where a change point was
/// passed.
SeriesSet over_time(const Story& story);

/// The same over the moments of the story's curve, where it has one: as fine as a plot is wide.
SeriesSet over_curve(const Story& story);

/// Steps of the motion at which a pose was reached.
std::vector<int> motion_steps(const Story& story);

/// Indices of all series.
std::vector<int> all_of(const SeriesSet& set);

}  // namespace jw::series
