#include "app/commands/plot_picture.hpp"

#include <imgui.h>

#include "app/host/panel_context.hpp"
#include "app/panels/frame.hpp"
#include "app/panels/theme.hpp"
#include "render/imgui_backend.hpp"
#include "render/offscreen.hpp"

namespace jw {

render::Image picture_of_plot(
    const SeriesSet& set, const panels::PlotState& state, const std::string& title, int width, int height) {
    render::Offscreen offscreen(width, height);
    const host::PanelContext context(width, height);
    const render::Fonts fonts = render::load_fonts(panels::scale_of(width, height));
    const render::ImguiBackend backend(offscreen.gl());
    offscreen.begin_3d(panels::theme::kPaper);
    offscreen.begin_2d();
    ImGui::NewFrame();
    const panels::Canvas canvas(ImGui::GetBackgroundDrawList(), fonts);
    const float margin = canvas.px(16.0F);
    const float head = canvas.line_height(fonts.bold) + canvas.px(10.0F);
    canvas.text({margin, margin}, fonts.bold, panels::theme::kInk, title);
    const panels::Box box{
        margin, margin + head, static_cast<float>(width) - 2.0F * margin,
        static_cast<float>(height) - 2.0F * margin - head};
    panels::plot(canvas, box, set, state);
    ImGui::Render();
    backend.draw(*ImGui::GetDrawData(), offscreen.size());
    return offscreen.read();
}

}  // namespace jw
