#pragma once

#include <optional>
#include <string>

#include "app/host/ui/ui.hpp"

/// Buttons of the bar at the foot of the window.
namespace jw::host {

/// Size of a button [pixels]; 0: as its label needs.
struct ButtonSize {
    float width = 0.0F;
    float height = 0.0F;
};

/// "Play", or "Pause 7 s" with the time until the next still, which is also shown as a shrinking line.
void play_button(const LessonUi& ui, const ButtonSize& size);
void speed_button(const LessonUi& ui, const ButtonSize& size);
void menu_button(const LessonUi& ui, const ButtonSize& size);

/// All buttons side by side, as high as the row. If there is not enough room, buttons whose command is also
/// in the menu are left out.
/// @param steps  include the buttons that step and play
void row_of_buttons(const LessonUi& ui, const panels::Box& row, bool steps);

/// Label of the button that plays: "Play", "Pause", or "Pause 7 s" with the time until the next still.
std::string play_label(bool plays, std::optional<double> seconds_left);

/// Speed in few letters: "½ ×".
std::string short_speed(double speed);

}  // namespace jw::host
