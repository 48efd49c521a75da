#pragma once

#include <optional>
#include <string>

#include "app/host/ui/ui.hpp"

/// Buttons of the bar at the foot of the window, and what two of them open: the menu and the list of keys.
namespace jw::host {

/// Buttons beside the line of steps: those that step and play, or the others. The first one is at the cursor.
void buttons_beside_line(const LessonUi& ui, bool steps);

/// All buttons side by side, as high as the row. If there is not enough room, buttons whose command is also
/// in the menu are left out.
/// @param steps  include the buttons that step and play
void row_of_buttons(const LessonUi& ui, const panels::Box& row, bool steps);

/// Label of the button that plays: "Play", "Pause", or "Pause 7 s" with the time until the next still.
std::string play_label(bool plays, std::optional<double> seconds_left);

/// Speed in few letters: "½ ×".
std::string short_speed(double speed);

/// Menu of all commands with their keys, opened by ImGui::OpenPopup("menu").
void menu(const LessonUi& ui);

/// The list of keys and mouse actions, over everything.
void help_overlay(const Ui& ui, const panels::Box& window);

}  // namespace jw::host
