#pragma once

#include <imgui.h>

namespace jw::host {

/// ImGui context for pictures without a window: it uses neither files nor a clock. It is current from its
/// creation to `leave`, and again from `enter` to `leave`; between frames the previous context is current
/// again.
class PanelContext {
public:
    /// Size in pixels.
    PanelContext(int width, int height)
        : before_(ImGui::GetCurrentContext()), context_(ImGui::CreateContext()) {
        ImGui::SetCurrentContext(context_);
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.LogFilename = nullptr;
        io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
        io.DeltaTime = 1.0F / 30.0F;
    }
    ~PanelContext() {
        ImGui::DestroyContext(context_);
        leave();
    }
    PanelContext(const PanelContext&) = delete;
    PanelContext& operator=(const PanelContext&) = delete;

    /// True if another context was current when this one was created.
    bool is_above_another() const { return before_ != nullptr; }

    void enter() const {
        // do not write needlessly: a thread that loads fonts may be reading the current context
        if (ImGui::GetCurrentContext() != context_) { ImGui::SetCurrentContext(context_); }
    }
    void leave() const {
        if (before_ != nullptr) { ImGui::SetCurrentContext(before_); }
    }

private:
    ImGuiContext* before_;
    ImGuiContext* context_;
};

}  // namespace jw::host
