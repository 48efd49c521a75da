#include "app/host/parts/waiting_sheet.hpp"

#include <algorithm>

#include <imgui.h>

#include "app/host/ui/widgets.hpp"
#include "app/panels/parts/parts.hpp"
#include "app/panels/parts/theme.hpp"
#include "app/session/wording/messages.hpp"

namespace jw::host {

namespace {

constexpr float kSheetWidth = 380.0F;

}  // namespace

const char* words_of_waiting() { return tr("Solving the lesson, joint by joint …"); }

bool waiting_sheet(const Ui& ui, const panels::Box& room, double part) {
    const float width = std::min(ui.px(kSheetWidth), room.width);
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const float margin = ui.px(14.0F);
    const float height = 2.0F * (line + ImGui::GetStyle().ItemSpacing.y + margin) + ImGui::GetFrameHeight();
    const panels::Box sheet{
        room.x + 0.5F * (room.width - width), room.y + 0.5F * (room.height - height), width, height};
    ImGui::SetNextWindowPos({sheet.x, sheet.y});
    ImGui::SetNextWindowSize({sheet.width, sheet.height});
    // above the widgets of the lesson that is still shown; but a slider that is held must stay held
    if (!ImGui::IsAnyItemActive()) { ImGui::SetNextWindowFocus(); }
    ImGui::Begin(
        "waiting", nullptr,
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
            ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::SetCursorPos({margin, margin});
    ImGui::BeginGroup();
    const panels::Canvas canvas(ImGui::GetWindowDrawList(), ui.canvas);
    const float line_width = ui.px(1.0F);
    const panels::Box inside{
        sheet.x + line_width, sheet.y + line_width, sheet.width - 2.0F * line_width,
        sheet.height - 2.0F * line_width};
    panels::sheet(canvas, inside, panels::theme::kWhite, panels::theme::kAccent);
    ImGui::TextUnformatted(words_of_waiting());
    ImGui::ProgressBar(static_cast<float>(part), {width - 2.0F * margin, line});
    const bool pressed = ImGui::Button(tr("Stop"));
    if (!is_for_fingers()) {
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(tr("or press Escape; what was open stays"));
    }
    ImGui::EndGroup();
    ImGui::End();
    return pressed;
}

}  // namespace jw::host
