#pragma once

#include <string>

#include "app/host/ui/ui.hpp"

struct ImGuiStyle;

/// Buttons, sliders and the like in the look of the panels.
namespace jw::host {

/// A part of the window that holds ImGui's own widgets: no title, no border, does not move.
class Area {
public:
    /// @param scrolls  a bar at the side where the contents do not fit
    Area(const Ui& ui, const char* name, const panels::Box& box, bool scrolls = false);
    ~Area();
    Area(const Area&) = delete;
    Area& operator=(const Area&) = delete;
};

/// Colours and sizes of ImGui's widgets as those of the panels.
/// @param for_fingers  what can be pressed is higher, and further apart
void set_style(ImGuiStyle& style, float scale, bool dark, bool for_fingers);

/// True if the present style is for fingers.
bool is_for_fingers();

/// A button for a command, with its keys as a tip. `label` may be short; the table's words are in the tip.
void command_button(
    const Ui& ui, Command command, const char* label, float width = 0.0F, float height = 0.0F);

/// A button no higher than its words, in a line of text; for fingers one like all others.
bool small_button(const char* label);

/// Words about the item before while the pointer is on it, wrapped where the window is narrow.
void tip_of_item(const std::string& text);
/// Words about an item that carries out a command: what it does, and its keys.
void tip_of_command(Command command);

/// A button that stays down while `on`.
bool toggle_button(const Ui& ui, const char* label, bool on, float width = 0.0F);

/// Bold words with a hairline below.
void section(const Ui& ui, const char* title);

/// Wrapped words in the small font.
void note(const Ui& ui, const std::string& text);

/// Width of the next widget: `most`, or less where its label, which stands at its right, needs the room.
void width_beside_label(const Ui& ui, const char* label, float most);

/// Rest of a column that scrolls, below the cursor, at least so high.
panels::Box rest_of_column(const Ui& ui, const panels::Box& column, float least);
/// Makes what was drawn at `place` part of what scrolls.
void end_column_at(const panels::Box& place);

/// Puts the next radio button or tick beside the last one, at a multiple of `step` from the left, where its
/// text fits there; else it begins a line.
void beside_if_it_fits(const char* label, float step);

/// A list of the four coordinate choices, to choose one from.
/// @return true if another one was chosen
bool choose_coordinates(const char* id, float width, CoordinateChoice& choice);

}  // namespace jw::host
