#pragma once

#include <array>
#include <cfloat>
#include <functional>
#include <optional>
#include <string>

#include <imgui.h>

#include "app/host/ui/ui.hpp"
#include "app/session/wording/messages.hpp"

/// Buttons, sliders and the like in the look of the panels.
namespace jw::host {

/// A fixed part of the window that holds ImGui's own widgets, without title and border.
class Area {
public:
    /// @param scrolls  shows a scroll bar if the contents do not fit
    Area(const Ui& ui, const char* name, const panels::Box& box, bool scrolls = false);
    ~Area();
    Area(const Area&) = delete;
    Area& operator=(const Area&) = delete;
};

/// Gives ImGui's widgets the colours and sizes of the panels.
/// @param for_fingers  widgets are higher and further apart
void set_style(ImGuiStyle& style, float scale, bool dark, bool for_fingers);

/// True if the current style is for fingers.
bool is_for_fingers();

/// A button for a command. Its tip has the words of the command table and the keys, so `label` may be short.
void command_button(
    const Ui& ui, Command command, const char* label, float width = 0.0F, float height = 0.0F);

/// A button as high as its text, for a line of text; for fingers it has the usual height.
bool small_button(const char* label);

/// Tip for the last item, shown while the pointer is on it; wrapped to `widest`, or to a narrow window.
void tip_of_item(const std::string& text, float widest = FLT_MAX);
/// Tip for an item that carries out a command: what the command does, and its keys.
void tip_of_command(Command command);

/// A button that stays down while `on`.
bool toggle_button(const Ui& ui, const char* label, bool on, float width = 0.0F);

/// A bold title with a thin line below.
void section(const Ui& ui, const char* title);

/// Wrapped text in the small font.
void note(const Ui& ui, const std::string& text);

/// Sets the width of the next widget to `most`, or less if the label at its right needs the room.
void width_beside_label(const Ui& ui, const char* label, float most);

/// Rest of a scrolling column below the cursor, at least `least` high.
panels::Box rest_of_column(const Ui& ui, const panels::Box& column, float least);
/// Adds the area `place`, which was drawn into, to the scrolled contents.
void end_column_at(const panels::Box& place);

/// Puts the next radio button or check box beside the last one, at a multiple of `step` from the left, if its
/// text fits there; else on a new line.
void beside_if_it_fits(const char* label, float step);

/// A list to select one of the values of a table.
/// @return true if another one was chosen
template <class E, std::size_t N>
bool choose(const char* id, float width, const std::array<EnumWord<E>, N>& table, E& value) {
    ImGui::SetNextItemWidth(width);
    if (!ImGui::BeginCombo(id, tr(label_of(table, value)))) { return false; }
    const E before = value;
    for (const EnumWord<E>& entry : table) {
        if (ImGui::Selectable(tr(entry.label), entry.value == before)) { value = entry.value; }
    }
    ImGui::EndCombo();
    return value != before;
}

/// Radio buttons for the values of a table, side by side where they fit, at multiples of `step`.
/// @return the value that was pressed
template <class E, std::size_t N>
std::optional<E> radio_buttons(const std::array<EnumWord<E>, N>& table, E value, float step) {
    std::optional<E> pressed;
    for (const EnumWord<E>& entry : table) {
        if (&entry != &table.front()) { beside_if_it_fits(tr(entry.label), step); }
        if (ImGui::RadioButton(tr(entry.label), value == entry.value)) { pressed = entry.value; }
    }
    return pressed;
}

/// Draws content that may be higher than its part of the window. It is then scrolled by the wheel, the scroll
/// bar and the commands of the panel.
/// @param height  of the content; `draw` gets a box of that height
void scrolled(
    const Ui& ui, const panels::Box& box, float height, Scroll& scroll,
    const std::function<void(const panels::Canvas&, const panels::Box&)>& draw);

}  // namespace jw::host
