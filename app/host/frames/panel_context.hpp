#pragma once

struct ImGuiContext;

namespace jw::host {

/// ImGui context for pictures without a window: it uses neither files nor a clock. It is current from its
/// creation to `leave`, and again from `enter` to `leave`; between frames the previous context is current
/// again.
class PanelContext {
public:
    /// Size in pixels.
    PanelContext(int width, int height);
    ~PanelContext();
    PanelContext(const PanelContext&) = delete;
    PanelContext& operator=(const PanelContext&) = delete;

    /// True if another context was current when this one was created.
    bool is_above_another() const { return before_ != nullptr; }

    void enter() const;
    void leave() const;

private:
    ImGuiContext* before_;
    ImGuiContext* context_;
};

}  // namespace jw::host
