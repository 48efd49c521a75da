#include "app/host/parts/menu.hpp"

#include <algorithm>

#include <imgui.h>

#include "app/host/ui/widgets.hpp"
#include "app/panels/parts/parts.hpp"
#include "app/panels/parts/theme.hpp"

namespace jw::host {

namespace {

using panels::Box;
namespace theme = panels::theme;

constexpr Group kGroups[] = {
    Group::timeline, Group::panels, Group::experiments, Group::picture, Group::files};

constexpr const char* kMouse[][2] = {
    {"Drag a body", "pull it: what is assembled holds it"},
    {"Drag the background", "turn the view"},
    {"Right button or Shift", "move the view"},
    {"Wheel", "nearer or farther"},
    {"Point at anything", "what belongs to it lights up"},
    {"Click a row, a plot", "go there"},
};

bool is_possible(const LessonUi& ui, Command command) {
    if (command == Command::undo) { return !ui.session.undo_text().empty(); }
    if (command == Command::redo) { return !ui.session.redo_text().empty(); }
    if (command == Command::start_over) { return ui.session.is_changed(); }
    return true;
}

float draw_group(const panels::Canvas& canvas, const Box& column, float y, Group group) {
    const render::Fonts& fonts = canvas.fonts();
    canvas.text({column.x, y}, fonts.bold, theme::kInk, name_of(group));
    y += canvas.line_height(fonts.bold) + canvas.px(2.0F);
    for (const CommandInfo& info : command_table()) {
        if (info.group != group) { continue; }
        canvas.text({column.x, y}, fonts.normal, theme::kAccent, info.keys);
        canvas.text({column.x + canvas.px(96.0F), y}, fonts.normal, theme::kInk, info.text);
        y += canvas.line_height(fonts.normal);
    }
    return y + canvas.px(12.0F);
}

float draw_mouse(const panels::Canvas& canvas, const Box& column, float y) {
    const render::Fonts& fonts = canvas.fonts();
    canvas.text({column.x, y}, fonts.bold, theme::kInk, "Mouse");
    y += canvas.line_height(fonts.bold) + canvas.px(2.0F);
    for (const auto& [what, does] : kMouse) {
        canvas.text({column.x, y}, fonts.normal, theme::kAccent, what);
        canvas.text({column.x + canvas.px(190.0F), y}, fonts.normal, theme::kInk, does);
        y += canvas.line_height(fonts.normal);
    }
    return y;
}

}  // namespace

void menu(const LessonUi& ui) {
    if (!ImGui::BeginPopup("menu")) { return; }
    for (const Group group : kGroups) {
        if (!ImGui::BeginMenu(name_of(group))) { continue; }
        for (const CommandInfo& info : command_table()) {
            if (info.group != group) { continue; }
            if (ImGui::MenuItem(info.text, info.keys, false, is_possible(ui, info.command))) {
                ui.requests.add(info.command);
            }
        }
        ImGui::EndMenu();
    }
    ImGui::EndPopup();
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
    const Box sheet{window.centre().x - 0.5F * width, window.centre().y - 0.5F * height, width, height};
    canvas.fill(sheet, theme::kPaper, canvas.px(8.0F));
    canvas.outline(sheet, theme::kLine, panels::hairline(canvas), canvas.px(8.0F));
    Box inner = panels::shrunk(sheet, canvas.px(24.0F), canvas.px(18.0F));
    canvas.text({inner.x, inner.y}, canvas.fonts().title, theme::kInk, "Keys and mouse");
    canvas.text(
        {inner.right(), inner.y}, canvas.fonts().small, theme::kSoft, "any key or click closes this",
        panels::Align::right);
    panels::cut_top(inner, canvas.px(44.0F));
    const Box first = panels::column_of(inner, 0, 3);
    const Box second = panels::column_of(inner, 1, 3);
    const Box third = panels::column_of(inner, 2, 3);
    float y = draw_group(canvas, first, inner.y, Group::timeline);
    y = draw_group(canvas, first, y, Group::panels);
    draw_group(canvas, first, y, Group::experiments);
    y = draw_group(canvas, second, inner.y, Group::picture);
    draw_mouse(canvas, second, y);
    draw_group(canvas, third, inner.y, Group::files);
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) { ui.state.help = false; }
    ImGui::End();
    ImGui::PopStyleColor();
}

}  // namespace jw::host
