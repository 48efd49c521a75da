#include "app/host/tabs/panel_keys.hpp"

#include <algorithm>
#include <array>

#include <imgui.h>

#include "app/host/tabs/tabs.hpp"
#include "app/session/wording/messages.hpp"

namespace jw::host {

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
    ImGui::SetWindowFocus(area_of(state.tab));
    return tr("The arrows move in the panel, Space presses, Enter types a number; Escape returns.");
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
