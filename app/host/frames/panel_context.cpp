#include "app/host/frames/panel_context.hpp"

#include <imgui.h>

namespace jw::host {

PanelContext::PanelContext(int width, int height)
    : before_(ImGui::GetCurrentContext()), context_(ImGui::CreateContext()) {
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
    io.DeltaTime = 1.0F / 30.0F;
}

PanelContext::~PanelContext() {
    ImGui::DestroyContext(context_);
    leave();
}

void PanelContext::enter() const {
    // do not write needlessly: a thread that loads fonts may be reading the current context
    if (ImGui::GetCurrentContext() != context_) { ImGui::SetCurrentContext(context_); }
}

void PanelContext::leave() const {
    if (before_ != nullptr) { ImGui::SetCurrentContext(before_); }
}

}  // namespace jw::host
