#include "app/host/parts/bar_buttons.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <imgui.h>

#include "app/host/ui/widgets.hpp"
#include "app/panels/parts/theme.hpp"
#include "app/session/output/pace.hpp"
#include "app/session/wording/messages.hpp"

namespace jw::host {

namespace {

constexpr float kBetweenButtons = 4.0F;
constexpr double kLongestPause = 99.0;  // of a still [s], for the width of the button

enum class RowButton { first, back, play, motion, next, speed, lessons, menu, help };

/// A button of the row, from the left.
struct RowEntry {
    RowButton button;
    bool steps;    ///< it steps or plays, and is left out for a figure
    int given_up;  ///< order of removal if there is not enough room; 0 stays
    float width;   ///< beside the line of steps
};
constexpr std::array kRow{
    RowEntry{RowButton::first, true, 3, 34.0F},    RowEntry{RowButton::back, true, 0, 34.0F},
    RowEntry{RowButton::play, true, 0, 92.0F},     RowEntry{RowButton::motion, true, 4, 64.0F},
    RowEntry{RowButton::next, true, 0, 34.0F},     RowEntry{RowButton::speed, true, 2, 52.0F},
    RowEntry{RowButton::lessons, false, 0, 74.0F}, RowEntry{RowButton::menu, false, 0, 54.0F},
    RowEntry{RowButton::help, false, 1, 26.0F}};
constexpr int kMostGivenUp = 4;

/// Size of a button [pixels]; height 0: as its label needs.
struct ButtonSize {
    float width = 0.0F;
    float height = 0.0F;
};

/// "Play", or "Pause 7 s" with the time until the next still, which is also shown as a shrinking line.
void play_button(const LessonUi& ui, const ButtonSize& size) {
    const std::optional<double> left = ui.state.playback.seconds_to_next_still(ui.session);
    const std::string label = play_label(ui.state.playback.plays(), left);
    command_button(ui, Command::play, label.c_str(), size.width, size.height);
    if (!left) { return; }
    const ImVec2 low = ImGui::GetItemRectMin();
    const double whole = seconds_of_step(ui.session.story(), ui.session.view());
    const auto part = static_cast<float>(std::clamp(*left * ui.state.playback.speed() / whole, 0.0, 1.0));
    ui.canvas.fill(
        {low.x, ImGui::GetItemRectMax().y + ui.px(2.0F), part * size.width, ui.px(3.0F)},
        panels::theme::kAccent);
}

void speed_button(const LessonUi& ui, const ButtonSize& size) {
    const std::string label = short_speed(ui.state.playback.speed()) + "##speed";
    if (ImGui::Button(label.c_str(), {size.width, size.height})) { ui.state.playback.next_speed(); }
    tip_of_item(tr("Speed  (, and .)"));
}

void menu_button(const LessonUi& ui, const ButtonSize& size) {
    if (ImGui::Button(tr("Menu"), {size.width, size.height})) { ImGui::OpenPopup("menu"); }
    menu(ui);
}

void draw_button(const LessonUi& ui, RowButton button, const ButtonSize& size) {
    const auto command = [&](Command c, const char* label) {
        command_button(ui, c, label, size.width, size.height);
    };
    switch (button) {
        case RowButton::first: return command(Command::first, "|<");
        case RowButton::back: return command(Command::back, "<");
        case RowButton::play: return play_button(ui, size);
        case RowButton::motion: return command(Command::play_motion, tr("Motion"));
        case RowButton::next: return command(Command::next, ">");
        case RowButton::speed: return speed_button(ui, size);
        case RowButton::lessons: return command(Command::lessons, tr("Lessons"));
        case RowButton::menu: return menu_button(ui, size);
        case RowButton::help: return command(Command::help, "?");
    }
}

float width_of_label(const std::string& label) {
    return ImGui::CalcTextSize(label.c_str(), nullptr, true).x + 2.0F * ImGui::GetStyle().FramePadding.x;
}

/// Width for the longest label of the button; buttons with short labels are square.
float needed_width(RowButton button, float height) {
    switch (button) {
        case RowButton::play:
            return std::max(
                width_of_label(play_label(true, kLongestPause)), width_of_label(play_label(false, {})));
        case RowButton::motion: return width_of_label(tr("Motion"));
        case RowButton::lessons: return width_of_label(tr("Lessons"));
        case RowButton::menu: return std::max(height, width_of_label(tr("Menu")));
        default: return height;
    }
}

std::vector<RowButton> shown_in_row(bool steps, int given_up) {
    std::vector<RowButton> shown;
    for (const RowEntry& entry : kRow) {
        const bool gone = entry.given_up > 0 && entry.given_up <= given_up;
        if (!gone && (steps || !entry.steps)) { shown.push_back(entry.button); }
    }
    return shown;
}

}  // namespace

std::string play_label(bool plays, std::optional<double> seconds_left) {
    if (!plays) { return tr("Play") + std::string("###play"); }
    if (!seconds_left) { return tr("Pause") + std::string("###play"); }
    return tr("Pause {0} s", static_cast<int>(std::ceil(*seconds_left))) + "###play";
}

std::string short_speed(double speed) {
    if (speed == 0.25) { return "¼ ×"; }
    if (speed == 0.5) { return "½ ×"; }
    return std::to_string(static_cast<int>(speed)) + " ×";
}

void buttons_beside_line(const LessonUi& ui, bool steps) {
    bool is_first = true;
    for (const RowEntry& entry : kRow) {
        if (entry.steps != steps) { continue; }
        if (!std::exchange(is_first, false)) { ImGui::SameLine(0.0F, ui.px(kBetweenButtons)); }
        draw_button(ui, entry.button, {ui.px(entry.width)});
    }
}

void row_of_buttons(const LessonUi& ui, const panels::Box& row, bool steps) {
    const float gap = ui.px(kBetweenButtons);
    std::vector<RowButton> shown;
    float needed = 0.0F;
    for (int given_up = 0; given_up <= kMostGivenUp; ++given_up) {
        shown = shown_in_row(steps, given_up);
        needed = gap * static_cast<float>(shown.size() - 1);
        for (const RowButton button : shown) { needed += needed_width(button, row.height); }
        if (needed <= row.width) { break; }
    }
    const float more = std::floor((row.width - needed) / static_cast<float>(shown.size()));
    float x = row.x;
    for (const RowButton button : shown) {
        const float width = std::max(1.0F, needed_width(button, row.height) + more);
        ImGui::SetCursorScreenPos({x, row.y});
        draw_button(ui, button, {width, row.height});
        x += width + gap;
    }
}

}  // namespace jw::host
