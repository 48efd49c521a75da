#pragma once

#include <string>

#include "app/host/tabs/exercise_tab.hpp"
#include "app/host/tabs/newton_tab.hpp"
#include "app/host/tabs/plot_tab.hpp"
#include "app/host/tabs/price_tab.hpp"
#include "app/host/tabs/rest_tab.hpp"
#include "app/host/ui/ui.hpp"

/// Column beside the picture: the panels of the step, or a tab to experiment and compare.
namespace jw::host {

/// State that the tabs keep between frames.
struct Tabs {
    PlotTab plot{};
    NewtonTab newton{};
    PriceTab price{};
    ExerciseTab exercises{};
    RestTab rest{};
};

/// The tabs and the column under them.
void side_column(
    const LessonUi& ui, const panels::FrameLayout& layout, Tabs& tabs, const Practice& practice,
    const ExerciseWork& work);

// ---- keys for the tab's widgets, in place of the commands of the arrows and a few other keys ----

/// Gives the keyboard to the widgets of the tab, or takes it away. The tab of the step has no widgets, so
/// the next tab is shown instead.
/// @return message that explains the keys; empty if there is nothing to explain
std::string use_panel_keys(UiState& state, bool on);

/// Handles an event while the widgets have the keyboard.
/// @return whether the event was for them
bool act_in_panel(const InputEvent& event, UiState& state);

}  // namespace jw::host
