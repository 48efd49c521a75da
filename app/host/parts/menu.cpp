#include "app/host/parts/bar_buttons.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <imgui.h>

#include "app/host/ui/widgets.hpp"
#include "app/panels/parts/parts.hpp"
#include "app/panels/parts/theme.hpp"
#include "app/session/wording/messages.hpp"

namespace jw::host {

namespace {

using panels::Box;
namespace theme = panels::theme;

constexpr float kColumnWidth = 350.0F;  // of the list of keys, at least
constexpr float kKeysWidth = 96.0F;
constexpr float kMouseWidth = 190.0F;

/// A line of the sheet: keys or a gesture, and their effect.
struct Line {
    const char* keys;
    const char* text;
};

constexpr Line kMouse[] = {
    {tr_later("Drag a body"), tr_later("pull it: the assembled joints constrain it")},
    {tr_later("Drag the background"), tr_later("turn the view")},
    {tr_later("Right button or Shift"), tr_later("move the view")},
    {tr_later("Wheel"), tr_later("zoom in or out")},
    {tr_later("Point at anything"), tr_later("what belongs to it is highlighted")},
    {tr_later("Click a row, a plot"), tr_later("go there")},
};

constexpr Line kFingers[] = {
    {tr_later("One finger"), tr_later("turn the view, scroll a panel")},
    {tr_later("Two fingers"), tr_later("move the view; zoom in or out")},
    {tr_later("Hold a finger on a body, then move"), tr_later("pull it: the assembled joints constrain it")},
    {tr_later("Tap a row, a plot"), tr_later("go there")},
};

bool is_offered(const Ui& ui, Command command) {
    return std::ranges::find(ui.state.not_offered, command) == ui.state.not_offered.end();
}

bool is_possible(const LessonUi& ui, Command command) {
    if (command == Command::undo) { return !ui.session.undo_text().empty(); }
    if (command == Command::redo) { return !ui.session.redo_text().empty(); }
    if (command == Command::start_over) { return ui.session.is_changed(); }
    return true;
}

struct Section {
    const char* title;
    std::vector<Line> lines;
    float keys_width = 0.0F;  ///< at 720
};

std::vector<Section> sections(const Ui& ui) {
    std::vector<Section> all;
    for (const auto& [group, name] : kGroups) {
        Section section{tr(name), {}, kKeysWidth};
        for (const CommandInfo& info : command_table()) {
            if (info.group == group && is_offered(ui, info.command)) {
                section.lines.push_back({tr(info.keys), tr(info.text)});
            }
        }
        all.push_back(std::move(section));
    }
    Section pointing{is_for_fingers() ? tr("Fingers") : tr("Mouse"), {}, kMouseWidth};
    const std::span<const Line> gestures = is_for_fingers() ? std::span<const Line>(kFingers) : kMouse;
    for (const auto& [what, does] : gestures) { pointing.lines.push_back({tr(what), tr(does)}); }
    // on phones the gestures matter most, so they come first
    all.insert(is_for_fingers() ? all.begin() : all.end(), std::move(pointing));
    return all;
}

/// @return the height used; a measuring canvas draws nothing
float draw_section(const panels::Canvas& canvas, const Box& column, const Section& section) {
    const render::Fonts& fonts = canvas.fonts();
    canvas.text({column.x, column.y}, fonts.bold, theme::kInk, section.title);
    float y = column.y + canvas.line_height(fonts.bold) + canvas.px(2.0F);
    const float keys = canvas.px(section.keys_width);
    for (const Line& line : section.lines) {
        const Box left{column.x, y, keys - canvas.px(6.0F), 0.0F};
        const Box right{column.x + keys, y, column.width - keys, 0.0F};
        const float high = panels::paragraph(canvas, left, fonts.normal, theme::kAccent, line.keys);
        y += std::max(high, panels::paragraph(canvas, right, fonts.normal, theme::kInk, line.text));
    }
    return y + canvas.px(12.0F) - column.y;
}

/// Draws the sections in columns of about the same height. @return the height of the highest column
float draw_sections(const panels::Canvas& canvas, const Box& box, const std::vector<Section>& all) {
    const float gap = canvas.px(20.0F);
    const int count = std::clamp(static_cast<int>(box.width / canvas.px(kColumnWidth)), 1, 3);
    const float width = (box.width - gap * static_cast<float>(count - 1)) / static_cast<float>(count);
    float total = 0.0F;
    for (const Section& s : all) { total += draw_section(canvas.measuring(), {0.0F, 0.0F, width, 0.0F}, s); }
    Box column{box.x, box.y, width, 0.0F};
    float highest = 0.0F;
    float left = total;
    int columns_left = count;
    for (const Section& section : all) {
        const float needed = draw_section(canvas.measuring(), column, section);
        const float used = column.y - box.y;
        // a section that is more than half beyond the share of its column begins the next column
        if (used > 0.0F && columns_left > 1 &&
            used + 0.5F * needed > (used + left) / static_cast<float>(columns_left)) {
            column.x += width + gap;
            column.y = box.y;
            --columns_left;
        }
        draw_section(canvas, column, section);
        column.y += needed;
        left -= needed;
        highest = std::max(highest, column.y - box.y);
    }
    return highest;
}

void menu_of_group(const LessonUi& ui, Group group, const char* name) {
    if (!ImGui::BeginMenu(name)) { return; }
    for (const CommandInfo& info : command_table()) {
        if (info.group != group || !is_offered(ui, info.command)) { continue; }
        if (ImGui::MenuItem(tr(info.text), tr(info.keys), false, is_possible(ui, info.command))) {
            ui.requests.add(info.command);
        }
    }
    ImGui::EndMenu();
}

/// Draws the list of keys, which can be scrolled if it is higher than the sheet.
void draw_list_of_keys(const Ui& ui, const Box& box) {
    ImGui::SetCursorScreenPos({box.x, box.y});
    ImGui::PushStyleColor(ImGuiCol_ChildBg, {0.0F, 0.0F, 0.0F, 0.0F});
    ImGui::BeginChild("list of keys", {box.width, box.height});
    const panels::Canvas canvas(ImGui::GetWindowDrawList(), ui.canvas);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Box place{at.x, at.y, ImGui::GetContentRegionAvail().x, 0.0F};
    ImGui::Dummy({1.0F, draw_sections(canvas, place, sections(ui))});
    if (ui.state.sheet.wanted != 0.0F) {
        ImGui::SetScrollY(ImGui::GetScrollY() + ui.state.sheet.wanted * box.height);
        ui.state.sheet.wanted = 0.0F;
    }
    ImGui::EndChild();
    ImGui::PopStyleColor();
}

/// @return the height used
float draw_head_of_keys(const panels::Canvas& canvas, const Box& box) {
    const render::Fonts& fonts = canvas.fonts();
    const char* const title = is_for_fingers() ? tr("Keys and fingers") : tr("Keys and mouse");
    const char* const note = tr("any other key or a click closes this");
    canvas.text({box.x, box.y}, fonts.title, theme::kInk, title);
    const float needed = canvas.text_width(fonts.title, title) + canvas.text_width(fonts.small, note);
    if (needed + canvas.px(12.0F) <= box.width) {
        canvas.text({box.right(), box.y}, fonts.small, theme::kSoft, note, panels::Align::right);
        return canvas.px(44.0F);
    }
    Box below = box;
    panels::cut_top(below, canvas.line_height(fonts.title) + canvas.px(2.0F));
    return below.y - box.y + panels::paragraph(canvas, below, fonts.small, theme::kSoft, note) +
           canvas.px(12.0F);
}

}  // namespace

void menu(const LessonUi& ui) {
    if (!ImGui::IsPopupOpen("menu")) { return; }
    // fingers need entries that are further apart
    const ImVec2 usual = ImGui::GetStyle().ItemSpacing;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {usual.x, is_for_fingers() ? ui.px(14.0F) : usual.y});
    if (ImGui::BeginPopup("menu")) {
        for (const auto& [group, name] : kGroups) { menu_of_group(ui, group, tr(name)); }
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar();
}

void help_overlay(const Ui& ui, const Box& window) {
    if (!ui.state.help) { return; }
    ImGui::SetNextWindowPos({window.x, window.y});
    ImGui::SetNextWindowSize({window.width, window.height});
    ImGui::SetNextWindowFocus();
    ImGui::PushStyleColor(ImGuiCol_WindowBg, {0.0F, 0.0F, 0.0F, 0.45F});
    ImGui::Begin(
        "keys", nullptr,
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
            ImGuiWindowFlags_NoNav);
    const panels::Canvas canvas(ImGui::GetWindowDrawList(), ui.canvas);
    const float width = std::min(window.width - canvas.px(40.0F), canvas.px(1180.0F));
    const float height = std::min(window.height - canvas.px(40.0F), canvas.px(640.0F));
    const Box sheet{
        std::round(window.centre().x - 0.5F * width), std::round(window.centre().y - 0.5F * height), width,
        height};
    canvas.fill(sheet, theme::kPaper, canvas.px(8.0F));
    canvas.outline(sheet, theme::kLine, panels::hairline(canvas), canvas.px(8.0F));
    Box inner = panels::shrunk(sheet, canvas.px(24.0F), canvas.px(18.0F));
    panels::cut_top(inner, draw_head_of_keys(canvas, inner));
    draw_list_of_keys(ui, inner);
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !ImGui::IsAnyItemActive()) { ui.state.help = false; }
    ImGui::End();
    ImGui::PopStyleColor();
}

}  // namespace jw::host
