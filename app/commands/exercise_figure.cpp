#include "app/commands/exercise_figure.hpp"

#include <algorithm>

#include <imgui.h>

#include "app/host/frames/panel_context.hpp"
#include "app/panels/frame/annotations.hpp"
#include "app/panels/parts/theme.hpp"
#include "app/session/picture/still.hpp"
#include "render/files/png.hpp"
#include "render/fonts/fonts.hpp"
#include "render/passes/imgui_backend.hpp"
#include "render/passes/scene_renderer.hpp"
#include "render/surface/offscreen.hpp"

namespace jw {

namespace {

// at this size, the letters of a figure are as large as those of a picture 720 high
constexpr float kFigureWidth = 576.0F;
constexpr float kFigureHeight = 360.0F;
// room for names beside the bodies at that size
constexpr double kFigureMargin = 34.0;

}  // namespace

struct ExerciseFigures::Surface {
    Surface(int width, int height)
        : offscreen(width, height),
          renderer(offscreen.gl()),
          context(width, height),
          fonts(render::load_fonts(std::min(
              static_cast<float>(width) / kFigureWidth, static_cast<float>(height) / kFigureHeight))),
          backend(offscreen.gl()),
          whole{0.0, 0.0, static_cast<double>(width), static_cast<double>(height)} {
        context.leave();
    }

    render::Image draw(const Picture& picture, const render::Camera& camera);

    render::Offscreen offscreen;
    render::SceneRenderer renderer;
    host::PanelContext context;
    render::Fonts fonts;
    render::ImguiBackend backend;
    render::Rect whole;
};

render::Image ExerciseFigures::Surface::draw(const Picture& picture, const render::Camera& camera) {
    context.enter();
    offscreen.begin_3d(panels::theme::kWhite);
    renderer.draw(
        picture.scene, camera, whole, offscreen.targets(), render::Tone::light, render::Backdrop::paper);
    offscreen.begin_2d();
    ImGui::NewFrame();
    const panels::Canvas canvas(ImGui::GetBackgroundDrawList(), fonts);
    panels::draw_annotations(canvas, picture, camera, whole, 0.0F, panels::BodyNames::all);
    ImGui::Render();
    backend.draw(*ImGui::GetDrawData(), offscreen.size());
    context.leave();
    return offscreen.read();
}

ExerciseFigures::ExerciseFigures(int width, int height)
    : surface_(std::make_unique<Surface>(width, height)) {}

ExerciseFigures::~ExerciseFigures() { surface_->offscreen.make_current(); }

std::vector<std::uint8_t> ExerciseFigures::png_of(const Lesson& lesson, bool as_given) {
    const Still still(lesson, as_given);
    const render::Rect safe =
        render::shrunk(surface_->whole, kFigureMargin * static_cast<double>(surface_->fonts.scale));
    return render::encode_png(surface_->draw(still.picture(), still.camera(surface_->whole, safe)));
}

}  // namespace jw
