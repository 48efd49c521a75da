#pragma once

struct ImGuiContext;

namespace jw::host {

/// ImGui for pictures without a window: nothing is read from or written to a file, no clock. It is current
/// from its making to `leave`, and again from `enter`; the one that was current before comes back between
/// frames.
class PanelContext {
public:
    /// Pixels.
    PanelContext(int width, int height);
    ~PanelContext();
    PanelContext(const PanelContext&) = delete;
    PanelContext& operator=(const PanelContext&) = delete;

    /// True if another one was current when this was made.
    bool is_above_another() const { return before_ != nullptr; }

    void enter() const;
    void leave() const;

private:
    ImGuiContext* before_;
    ImGuiContext* context_;
};

}  // namespace jw::host
