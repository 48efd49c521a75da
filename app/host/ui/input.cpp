#include "app/host/ui/input.hpp"

#include <cfloat>
#include <string_view>

#include <imgui.h>

namespace jw::host {

Key key_of_letter(char letter) {
    constexpr std::string_view letters = "acoqrsvxyz";
    static_assert(static_cast<std::size_t>(Key::z) - static_cast<std::size_t>(Key::a) + 1 == letters.size());
    const std::size_t place = letters.find(letter);
    if (place == std::string_view::npos) { return Key::none; }
    return static_cast<Key>(static_cast<std::size_t>(Key::a) + place);
}

std::vector<InputEvent> InputQueue::take() {
    std::size_t end = 0;
    bool changed = false;
    bool moved = false;
    for (; end < waiting_.size(); ++end) {
        const InputEvent& event = waiting_[end];
        const bool change = event.kind == InputEvent::Kind::button || event.kind == InputEvent::Kind::key;
        if (change && changed) { break; }
        // the pointer must be in place before the button goes down, and stay there until it is down
        if (changed && event.kind == InputEvent::Kind::pointer) { break; }
        // a held object must follow the pointer before it is released
        if (moved && event.kind == InputEvent::Kind::button && !event.down) { break; }
        moved = moved || event.kind == InputEvent::Kind::pointer;
        changed = changed || change;
    }
    const auto last = waiting_.begin() + static_cast<std::ptrdiff_t>(end);
    std::vector<InputEvent> taken(waiting_.begin(), last);
    waiting_.erase(waiting_.begin(), last);
    return taken;
}

void map_keys(ImGuiIO& io) {
    const auto map = [&](ImGuiKey to, Key from) { io.KeyMap[to] = static_cast<int>(from); };
    map(ImGuiKey_LeftArrow, Key::left);
    map(ImGuiKey_RightArrow, Key::right);
    map(ImGuiKey_UpArrow, Key::up);
    map(ImGuiKey_DownArrow, Key::down);
    map(ImGuiKey_Home, Key::home);
    map(ImGuiKey_End, Key::end);
    map(ImGuiKey_PageUp, Key::page_up);
    map(ImGuiKey_PageDown, Key::page_down);
    map(ImGuiKey_Space, Key::space);
    map(ImGuiKey_Enter, Key::enter);
    map(ImGuiKey_Escape, Key::escape);
    map(ImGuiKey_Tab, Key::tab);
    map(ImGuiKey_Backspace, Key::backspace);
    map(ImGuiKey_Delete, Key::del);
    map(ImGuiKey_A, Key::a);
    map(ImGuiKey_C, Key::c);
    map(ImGuiKey_V, Key::v);
    map(ImGuiKey_X, Key::x);
    map(ImGuiKey_Y, Key::y);
    map(ImGuiKey_Z, Key::z);
}

void feed(ImGuiIO& io, const InputEvent& event) {
    switch (event.kind) {
        case InputEvent::Kind::pointer: io.MousePos = {event.x, event.y}; break;
        case InputEvent::Kind::button:
            if (event.number >= 0 && event.number <= kTurningButton) {
                io.MouseDown[event.number] = event.down;
            }
            break;
        case InputEvent::Kind::wheel: io.MouseWheel += event.y; break;
        case InputEvent::Kind::key:
            if (event.key == Key::ctrl) { io.KeyCtrl = event.down; }
            if (event.key == Key::shift) { io.KeyShift = event.down; }
            io.KeysDown[static_cast<int>(event.key)] = event.down;
            break;
        case InputEvent::Kind::text: io.AddInputCharacter(event.character); break;
        case InputEvent::Kind::leave:
            io.MousePos = {-FLT_MAX, -FLT_MAX};
            for (bool& down : io.MouseDown) { down = false; }
            for (bool& down : io.KeysDown) { down = false; }
            io.KeyCtrl = io.KeyShift = false;
            break;
    }
}

}  // namespace jw::host
