#pragma once

#include "app/host/newton_tab.hpp"
#include "app/host/plot_tab.hpp"
#include "app/host/price_tab.hpp"
#include "app/host/ui.hpp"

/// What stands beside the picture: the panels of the step, or one of the benches to try and compare.
namespace jw::host {

const char* name_of(Tab tab);
/// ImGui's name of the part of the window that holds its widgets.
const char* area_of(Tab tab);

/// What the tabs remember.
struct Benches {
    PlotBench plot{};
    NewtonBench newton{};
    PriceBench price{};
};

/// The tabs and the column under them.
void side_column(const LessonUi& ui, const panels::FrameLayout& layout, Benches& benches);

}  // namespace jw::host
