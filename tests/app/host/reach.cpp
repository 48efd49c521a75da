#include "tests/app/host/reach.hpp"

#include <algorithm>
#include <stdexcept>

#include <imgui.h>
#include <imgui_internal.h>

namespace jw::test {

namespace {

// at 1280x720 no widget is narrower or lower than this
constexpr float kAcross = 18.0F;
constexpr float kDown = 13.0F;
constexpr float kTop = 0.25F;  // of the way down: a place at which nothing but the column scrolls

unsigned hovered(Person& person, float x, float y) {
    person.host().push(host::InputEvent::pointer(x, y));
    person.frame();
    return ImGui::GetCurrentContext()->HoveredId;
}

}  // namespace

std::vector<Widget> widgets_in(Person& person, const panels::Box& box) {
    std::vector<Widget> found;
    for (float y = box.y + 3.0F; y < box.bottom(); y += kDown) {
        for (float x = box.x + 3.0F; x < box.right(); x += kAcross) {
            const unsigned id = hovered(person, x, y);
            const auto same = [&](const Widget& w) { return w.id == id; };
            if (id != 0 && std::ranges::none_of(found, same)) { found.push_back({id, x + 2.0F, y + 2.0F}); }
        }
    }
    return found;
}

std::vector<Widget> widgets_at(Person& person, const panels::Box& column, int notches) {
    scroll_to(person, column, notches);
    return widgets_in(person, column);
}

int notches_of(Person& person, const char* window) {
    person.settle();
    const ImGuiWindow* const w = ImGui::FindWindowByName(window);
    if (w == nullptr) { return 0; }
    // a notch is five lines of text, but at most two thirds of the window
    const float notch = std::min(5.0F * w->CalcFontSize(), 0.67F * w->InnerRect.GetHeight());
    return static_cast<int>(std::ceil(w->ScrollMax.y / notch));
}

void scroll_to(Person& person, const panels::Box& column, int notches) {
    constexpr float kBeyondTheTop = 1000.0F;
    person.point(column.right() - 40.0F, column.y + kTop * column.height);
    person.wheel(kBeyondTheTop);
    for (int k = 0; k < notches; ++k) { person.wheel(-1.0F); }
}

unsigned id_of(const char* window, std::initializer_list<std::variant<std::string, int>> path) {
    const ImGuiWindow* const w = ImGui::FindWindowByName(window);
    if (w == nullptr) { throw std::runtime_error(std::string("no window ") + window); }
    unsigned id = w->ID;
    for (const auto& part : path) {
        if (const auto* text = std::get_if<std::string>(&part)) {
            id = ImHashStr(text->c_str(), 0, id);
        } else {
            const int number = std::get<int>(part);
            id = ImHashData(&number, sizeof number, id);
        }
    }
    return id;
}

Widget find(Person& person, const char* window, std::initializer_list<std::variant<std::string, int>> path) {
    person.settle();
    const unsigned wanted = id_of(window, path);
    const ImGuiWindow* const w = ImGui::FindWindowByName(window);
    const panels::Box column{w->Pos.x, w->Pos.y, w->Size.x, w->Size.y};
    const int most = notches_of(person, window);
    for (int notches = 0; notches <= most; notches += 3) {
        scroll_to(person, column, notches);
        for (float y = column.y + 3.0F; y < column.bottom(); y += kDown) {
            for (float x = column.x + 3.0F; x < column.right(); x += kAcross) {
                if (hovered(person, x, y) == wanted) { return {wanted, x + 2.0F, y + 2.0F}; }
            }
        }
    }
    throw std::runtime_error(std::string("not found in ") + window);
}

const panels::Box* open_popup(panels::Box& box) {
    const ImGuiContext& g = *ImGui::GetCurrentContext();
    if (g.OpenPopupStack.empty() || g.OpenPopupStack.back().Window == nullptr) { return nullptr; }
    const ImGuiWindow& w = *g.OpenPopupStack.back().Window;
    box = {w.Pos.x, w.Pos.y, w.Size.x, w.Size.y};
    return &box;
}

}  // namespace jw::test
