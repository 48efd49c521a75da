#include "app/host/ui/scrolled.hpp"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "app/panels/parts/theme.hpp"

namespace jw::host {

namespace {

using panels::Box;
namespace theme = panels::theme;

constexpr float kBarWidth = 6.0F;
constexpr float kLeastThumb = 24.0F;
constexpr float kNotch = 54.0F;  // three lines

/// The scroll bar at the right edge, and the part of it that shows the visible range.
struct Bar {
    Box track;
    Box thumb;
};

Bar bar_of(const Ui& ui, const Box& box, float height, float offset) {
    Bar bar;
    bar.track = {
        box.right() - ui.px(kBarWidth + 2.0F), box.y + ui.px(3.0F), ui.px(kBarWidth),
        box.height - ui.px(6.0F)};
    const float size = std::max(ui.px(kLeastThumb), bar.track.height * box.height / height);
    const float way = std::max(0.0F, bar.track.height - size);
    bar.thumb = {bar.track.x, bar.track.y + way * offset / (height - box.height), bar.track.width, size};
    return bar;
}

void handle(const Ui& ui, const Box& box, float height, Scroll& scroll) {
    const ImGuiIO& io = ImGui::GetIO();
    const panels::Point mouse{io.MousePos.x, io.MousePos.y};
    const Bar bar = bar_of(ui, box, height, scroll.offset);
    const bool over = box.contains(mouse) && !io.WantCaptureMouse;
    if (over && io.MouseWheel != 0.0F) { scroll.offset -= io.MouseWheel * ui.px(kNotch); }
    const Box wide = panels::shrunk(bar.track, -ui.px(3.0F), 0.0F);
    if (over && ImGui::IsMouseClicked(ImGuiMouseButton_Left) && wide.contains(mouse)) { scroll.held = true; }
    scroll.held = scroll.held && io.MouseDown[0];
    if (scroll.held) {
        const float way = std::max(1.0F, bar.track.height - bar.thumb.height);
        const float part = (mouse.y - bar.track.y - 0.5F * bar.thumb.height) / way;
        scroll.offset = part * (height - box.height);
    }
}

}  // namespace

void scrolled(
    const Ui& ui, const Box& box, float height, Scroll& scroll,
    const std::function<void(const panels::Canvas&, const Box&)>& draw) {
    if (height <= box.height) {
        scroll = {};
        return draw(ui.canvas, box);
    }
    scroll.most = height - box.height;
    scroll.offset += scroll.wanted * box.height;
    scroll.wanted = 0.0F;
    handle(ui, box, height, scroll);
    scroll.offset = std::round(std::clamp(scroll.offset, 0.0F, height - box.height));
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.PushClipRect({box.x, box.y}, {box.right(), box.bottom()}, true);
    draw(ui.canvas.within(box), {box.x, box.y - scroll.offset, box.width, height});
    const Bar bar = bar_of(ui, box, height, scroll.offset);
    ui.canvas.fill(bar.track, theme::kShade, 0.5F * bar.track.width);
    ui.canvas.fill(bar.thumb, scroll.held ? theme::kSoft : theme::kFaint, 0.5F * bar.thumb.width);
    list.PopClipRect();
}

}  // namespace jw::host
