#pragma once

#include <functional>
#include <string>

#include "app/panels/plot/plot.hpp"
#include "render/image.hpp"

namespace jw {

/// One panel as a picture of its own, drawn in memory.
/// @param characters  of its texts beyond those of the interface
/// @throws std::runtime_error if OSMesa or a font is missing
render::Image picture_of_panel(
    int width, int height, const std::function<void(const panels::Canvas&, const panels::Box&)>& draw,
    const std::u32string& characters = {});

/// A plot as a picture of its own, drawn in memory.
/// @throws std::runtime_error if OSMesa or a font is missing
render::Image picture_of_plot(
    const SeriesSet& set, const panels::PlotState& state, const std::string& title, int width, int height);

}  // namespace jw
