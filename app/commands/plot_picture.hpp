#pragma once

#include <functional>
#include <string>

#include "app/panels/plot/plot.hpp"
#include "render/files/image.hpp"

namespace jw {

/// One panel as a separate picture, drawn in memory.
/// @param characters  of its texts that the interface does not have
/// @throws std::runtime_error if OSMesa or a font is missing
render::Image picture_of_panel(
    int width, int height, const std::function<void(const panels::Canvas&, const panels::Box&)>& draw,
    const std::u32string& characters = {});

/// A plot as a separate picture, drawn in memory.
/// @throws std::runtime_error if OSMesa or a font is missing
render::Image picture_of_plot(
    const SeriesSet& set, const panels::PlotState& state, const std::string& title, int width, int height);

}  // namespace jw
