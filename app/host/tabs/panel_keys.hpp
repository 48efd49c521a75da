#pragma once

#include <string>

#include "app/host/ui/ui.hpp"

/// The keyboard among the widgets of the panel, in place of the commands of the arrows and a few others.
namespace jw::host {

/// Gives the keyboard to the widgets of the tab, or takes it away; the step has none, so the first that has
/// is shown.
/// @return what somebody at the keyboard then has to know, if anything
std::string use_panel_keys(UiState& state, bool on);

/// Handles an event while the widgets have the keyboard.
/// @return whether it was for them
bool act_in_panel(const InputEvent& event, UiState& state);

}  // namespace jw::host
