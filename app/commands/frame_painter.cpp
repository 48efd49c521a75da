#include "app/commands/frame_painter.hpp"

#include <imgui.h>

#include "app/panels/frame.hpp"
#include "app/session/picture_camera.hpp"
#include "render/fonts.hpp"
#include "render/imgui_backend.hpp"
#include "render/offscreen.hpp"
#include "render/scene_renderer.hpp"

namespace jw {

namespace {

/// ImGui without a window: nothing is read from or written to a file, no clock.
class PanelContext {
public:
    PanelContext(int width, int height) : context_(ImGui::CreateContext()) {
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.LogFilename = nullptr;
        io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
        io.DeltaTime = 1.0F / 30.0F;
    }
    ~PanelContext() { ImGui::DestroyContext(context_); }
    PanelContext(const PanelContext&) = delete;
    PanelContext& operator=(const PanelContext&) = delete;

private:
    ImGuiContext* context_;
};

}  // namespace

struct FramePainter::Surface {
    Surface(int width, int height)
        : offscreen(width, height),
          scene(offscreen.gl()),
          context(width, height),
          fonts(render::load_fonts(panels::scale_of(width, height))),
          panels(offscreen.gl()),
          layout(panels::layout_of(width, height)) {}

    // destroyed from the last to the first: what holds GL objects goes before the context
    render::Offscreen offscreen;
    render::SceneRenderer scene;
    PanelContext context;
    render::Fonts fonts;
    render::ImguiBackend panels;
    panels::FrameLayout layout;
    render::Camera camera;
};

FramePainter::FramePainter(const Story& story, int width, int height)
    : story_(&story), style_(picture_style(story)), surface_(std::make_unique<Surface>(width, height)) {
    surface_->camera = camera_of(story, style_, surface_->layout.scene, surface_->layout.scene_safe);
}

FramePainter::~FramePainter() = default;

render::Image FramePainter::paint(const View& view) {
    Surface& s = *surface_;
    const Picture picture = picture_of(*story_, style_, view.step);
    s.offscreen.begin_3d();
    s.scene.draw(picture.scene, s.camera, s.layout.scene, s.offscreen.size());
    s.offscreen.begin_2d();
    ImGui::NewFrame();
    panels::draw_frame(view, picture, s.camera, s.layout, s.fonts);
    ImGui::Render();
    s.panels.draw(*ImGui::GetDrawData(), s.offscreen.size());
    return s.offscreen.read();
}

}  // namespace jw
