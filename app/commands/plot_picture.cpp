#include "app/commands/plot_picture.hpp"

#include <imgui.h>

#include "app/host/frames/panel_context.hpp"
#include "app/panels/frame/frame.hpp"
#include "app/panels/parts/characters.hpp"
#include "app/panels/parts/theme.hpp"
#include "render/passes/imgui_backend.hpp"
#include "render/surface/offscreen.hpp"

namespace jw {

render::Image picture_of_panel(
    int width, int height, const std::function<void(const panels::Canvas&, const panels::Box&)>& draw,
    const std::u32string& characters) {
    render::Offscreen offscreen(width, height);
    const host::PanelContext context(width, height);
    const render::Fonts fonts = render::load_fonts(panels::scale_of(width, height), characters);
    const render::ImguiBackend backend(offscreen.gl());
    offscreen.begin_3d(panels::theme::kPaper);
    offscreen.begin_2d();
    ImGui::NewFrame();
    const panels::Canvas canvas(ImGui::GetBackgroundDrawList(), fonts);
    const panels::Box all{0.0F, 0.0F, static_cast<float>(width), static_cast<float>(height)};
    const float margin = canvas.px(16.0F);
    draw(canvas, panels::shrunk(all, margin, margin));
    ImGui::Render();
    backend.draw(*ImGui::GetDrawData(), offscreen.size());
    return offscreen.read();
}

render::Image picture_of_plot(
    const SeriesSet& set, const panels::PlotState& state, const std::string& title, int width, int height) {
    const auto draw = [&](const panels::Canvas& canvas, panels::Box box) {
        const float head = canvas.line_height(canvas.fonts().bold) + canvas.px(10.0F);
        const panels::Box line = panels::cut_top(box, head);
        canvas.text({line.x, line.y}, canvas.fonts().bold, panels::theme::kInk, title);
        panels::draw_plot(canvas, panels::layout_plot(canvas, box, set, state), set, state);
    };
    return picture_of_panel(
        width, height, draw, panels::characters_in(title) + panels::characters_of_messages());
}

}  // namespace jw
