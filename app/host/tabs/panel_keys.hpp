#pragma once

#include <string>

#include "app/host/ui/ui.hpp"

/// Keyboard operation of the panel's widgets, in place of the commands of the arrows and a few other keys.
namespace jw::host {

/// Gives the keyboard to the widgets of the tab, or takes it away. The tab of the step has no widgets, so
/// the next tab is shown instead.
/// @return message that explains the keys; empty if there is nothing to explain
std::string use_panel_keys(UiState& state, bool on);

/// Handles an event while the widgets have the keyboard.
/// @return whether the event was for them
bool act_in_panel(const InputEvent& event, UiState& state);

}  // namespace jw::host
