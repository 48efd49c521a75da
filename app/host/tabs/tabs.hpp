#pragma once

#include "app/host/tabs/exercise_tab.hpp"
#include "app/host/tabs/newton_tab.hpp"
#include "app/host/tabs/plot_tab.hpp"
#include "app/host/tabs/price_tab.hpp"
#include "app/host/ui/ui.hpp"

/// Column beside the picture: the panels of the step, or a tab to experiment and compare.
namespace jw::host {

/// ImGui's name of the area that holds the widgets of a tab.
const char* area_of(Tab tab);

/// State that the tabs keep between frames.
struct Tabs {
    PlotTab plot{};
    NewtonTab newton{};
    PriceTab price{};
    ExerciseTab exercises{};
};

/// The tabs and the column under them.
void side_column(
    const LessonUi& ui, const panels::FrameLayout& layout, Tabs& tabs, const Practice& practice,
    const ExerciseWork& work);

}  // namespace jw::host
