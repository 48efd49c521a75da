#include "app/host/tabs/tabs.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include <imgui.h>

#include "app/host/tabs/experiment_tab.hpp"
#include "app/host/ui/widgets.hpp"
#include "app/panels/column/panels.hpp"
#include "app/panels/parts/parts.hpp"
#include "app/panels/parts/theme.hpp"
#include "app/session/wording/messages.hpp"

namespace jw::host {

namespace {

using panels::Box;
namespace theme = panels::theme;

/// The tabs of a lesson.
std::vector<EnumWord<Tab>> tabs_of(const Lesson& lesson) {
    std::vector<EnumWord<Tab>> tabs(kTabs.begin(), kTabs.end());
    std::erase_if(tabs, [&](const EnumWord<Tab>& tab) { return !has_tab(lesson, tab.value); });
    return tabs;
}

/// Places of the tabs side by side, each as wide as its words need.
std::vector<Box> places_of_tabs(
    const panels::Canvas& canvas, const Box& strip, std::span<const EnumWord<Tab>> tabs, const ImFont* font) {
    std::vector<float> widths;
    float all = 0.0F;
    for (const EnumWord<Tab>& tab : tabs) {
        widths.push_back(canvas.text_width(font, tab.label));
        all += widths.back();
    }
    const float room = std::max(0.0F, strip.width - all) / static_cast<float>(widths.size());
    std::vector<Box> places;
    float x = strip.x;
    for (const float width : widths) {
        places.push_back({x, strip.y, width + room, strip.height});
        x += width + room;
    }
    return places;
}

/// The largest font in which all tabs fit.
const ImFont* font_of_tabs(
    const panels::Canvas& canvas, const Box& strip, std::span<const EnumWord<Tab>> tabs) {
    float width = 0.0F;
    for (const EnumWord<Tab>& tab : tabs) {
        width += canvas.text_width(canvas.fonts().bold, tab.label) + canvas.px(8.0F);
    }
    return width <= strip.width ? canvas.fonts().bold : canvas.fonts().small;
}

void tab_strip(const LessonUi& ui, const Box& strip) {
    const panels::Canvas& canvas = ui.canvas;
    const std::vector<EnumWord<Tab>> tabs = tabs_of(ui.session.lesson());
    const ImFont* const widest = font_of_tabs(canvas, strip, tabs);
    const std::vector<Box> places = places_of_tabs(canvas, strip, tabs, widest);
    canvas.fill(strip, theme::kShade);
    Area area(ui, "tabs", strip);
    const int count = static_cast<int>(tabs.size());
    for (int k = 0; k < count; ++k) {
        const Tab tab = tabs[static_cast<std::size_t>(k)].value;
        const Box box = places[static_cast<std::size_t>(k)];
        const bool chosen = ui.state.tab == tab;
        ImGui::SetCursorScreenPos({box.x, box.y});
        ImGui::PushID(k);
        if (ImGui::InvisibleButton("tab", {box.width, box.height})) { ui.requests.add(command_of(tab)); }
        const bool hovered = ImGui::IsItemHovered();
        tip_of_command(command_of(tab));
        ImGui::PopID();
        if (chosen) {
            canvas.fill(box, theme::kPaper);
            canvas.fill({box.x, box.y, box.width, canvas.px(3.0F)}, theme::kAccent);
        }
        const bool small = widest == canvas.fonts().small;
        const ImFont* const font = small ? widest : (chosen ? canvas.fonts().bold : canvas.fonts().normal);
        const float y = box.centre().y - 0.5F * canvas.line_height(font);
        canvas.text(
            {box.centre().x, y}, font, chosen || hovered ? theme::kInk : theme::kSoft,
            tr(label_of(kTabs, tab)), panels::Align::centre);
    }
    canvas.fill({strip.x, strip.y, panels::hairline(canvas), strip.height}, theme::kLine);
}

}  // namespace

void side_column(
    const LessonUi& ui, const panels::FrameLayout& layout, Tabs& tabs, const Practice& practice,
    const ExerciseWork& work) {
    tab_strip(ui, layout.tabs);
    if (ui.state.tab != Tab::newton) { tabs.newton.forget_ghosts(); }
    if (ui.state.tab != Tab::rest) { tabs.rest.leave(); }
    if (ui.state.tab == Tab::step) {
        const View& view = ui.session.view();
        const float height = panels::column_height(ui.canvas, layout.column, view);
        return scrolled(ui, layout.column, height, ui.state.column, [&](const auto& canvas, const Box& box) {
            panels::draw_column(canvas, box, view);
        });
    }
    ui.canvas.fill(layout.column, theme::kPaper);
    ui.canvas.fill(
        {layout.column.x, layout.column.y, panels::hairline(ui.canvas), layout.column.height}, theme::kLine);
    switch (ui.state.tab) {
        case Tab::experiments: return experiment_tab(ui, layout.column);
        case Tab::plot: return tabs.plot.draw(ui, layout.column);
        case Tab::newton: return tabs.newton.draw(ui, layout.column);
        case Tab::price: return tabs.price.draw(ui, layout.column);
        case Tab::exercises: return tabs.exercises.draw(ui, layout.column, practice, work);
        case Tab::rest: return tabs.rest.draw(ui, layout.column);
        case Tab::step: return;
    }
}

std::string use_panel_keys(UiState& state, bool on) {
    ImGuiIO& io = ImGui::GetIO();
    state.panel_keys = on;
    if (!on) {
        io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
        ImGui::SetWindowFocus(nullptr);
        return {};
    }
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    if (state.tab == Tab::step) { state.tab = Tab::experiments; }
    // each area has the word of its tab as its name
    ImGui::SetWindowFocus(word_of(kTabs, state.tab));
    return tr("The arrows move in the panel, Space presses a button, Enter edits a number, Escape returns.");
}

bool act_in_panel(const InputEvent& event, UiState& state) {
    if (event.kind != InputEvent::Kind::key) { return false; }
    if (event.key == Key::escape) {
        if (!ImGui::GetIO().WantTextInput) { use_panel_keys(state, false); }
        return true;
    }
    // with these keys ImGui moves among its widgets
    constexpr std::array moving{Key::left, Key::right, Key::up, Key::down, Key::space, Key::enter, Key::tab};
    return std::ranges::find(moving, event.key) != moving.end();
}

}  // namespace jw::host
