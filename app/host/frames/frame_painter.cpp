#include "app/host/frames/frame_painter.hpp"

#include <cmath>
#include <future>
#include <optional>

#include <imgui.h>

#include "app/host/frames/panel_context.hpp"
#include "app/host/frames/vector_strokes.hpp"
#include "app/panels/frame/annotations.hpp"
#include "app/panels/frame/frame.hpp"
#include "app/panels/parts/characters.hpp"
#include "app/session/picture/picture_camera.hpp"
#include "app/session/picture/pointed_thing.hpp"
#include "render/fonts.hpp"
#include "render/id_buffer.hpp"
#include "render/imgui_backend.hpp"
#include "render/offscreen.hpp"
#include "render/render_targets.hpp"
#include "render/scene_renderer.hpp"

namespace jw::host {

namespace {

/// Pixels of the 3D part of a vector picture for each pixel of the frame.
constexpr double kSharper = 2.0;
// what a transparent picture begins with
constexpr render::Colour kNothing{0.0F, 0.0F, 0.0F, 0.0F};

std::u32string characters_of(const Story& story) {
    return panels::characters_of(story.lesson()) + panels::characters_of_messages();
}

/// Letters, made ready while this thread draws the first scene: either takes a third of the time to a first
/// picture.
std::future<render::Fonts> fonts_for(
    int width, int height, const FrameLook& look, const std::u32string& characters) {
    return std::async(
        [scale = look.scale(width, height), characters] { return render::load_fonts(scale, characters); });
}

panels::FrameLayout layout_for(int width, int height, const FrameLook& look) {
    const panels::Box frame{0.0F, 0.0F, static_cast<float>(width), static_cast<float>(height)};
    const float scale = look.scale(width, height);
    return look.has_panels ? panels::layout_in(frame, panels::FrameKind::picture, scale)
                           : panels::layout_without_panels(frame, scale);
}

}  // namespace

float FrameLook::scale(int width, int height) const {
    const float usual =
        has_panels ? panels::scale_of(width, height) : panels::scale_without_panels(width, height);
    return usual * static_cast<float>(text);
}

struct FramePainter::Surface {
    struct Panels {
        Panels(const render::Fonts& loaded, const render::GlFunctions& gl) : fonts(loaded), backend(gl) {}

        render::Fonts fonts;
        render::ImguiBackend backend;
    };

    Surface(int width, int height, const FrameLook& look, const std::u32string& characters)
        : context(width, height),
          loading(fonts_for(width, height, look, characters)),
          offscreen(std::in_place, width, height),
          functions(&offscreen->gl()),
          scene(offscreen->gl()),
          layout(layout_for(width, height, look)) {}
    Surface(int width, int height, const std::u32string& characters, const render::GlFunctions& gl)
        : context(width, height),
          loading(fonts_for(width, height, {}, characters)),
          targets(std::in_place, gl, width, height),
          functions(&gl),
          scene(gl),
          layout(layout_for(width, height, {})) {}

    /// Draws panels, once the letters are there. The context of ImGui must be current.
    /// @throws std::runtime_error if a font is missing
    Panels& panels() {
        if (!made_panels) { made_panels.emplace(loading.get(), *functions); }
        return *made_panels;
    }

    void begin_3d(const render::Colour& paper) {
        offscreen ? offscreen->begin_3d(paper) : targets->begin_3d(paper);
    }
    const render::RenderTargets& drawn_into() const { return offscreen ? offscreen->targets() : *targets; }
    void begin_2d() { offscreen ? offscreen->begin_2d() : targets->begin_2d(); }
    render::Image read(bool is_opaque) {
        return offscreen ? offscreen->read(is_opaque) : targets->read(is_opaque);
    }
    render::FrameSize size() const { return offscreen ? offscreen->size() : targets->size(); }
    void make_current() const {
        if (offscreen) { offscreen->make_current(); }
    }

    PanelContext context;
    // into the context above, which nobody else uses before they are there: see `compose_camera`
    std::future<render::Fonts> loading;
    // destroyed from the last to the first: what holds GL objects goes before their context
    std::optional<render::Offscreen> offscreen;
    std::optional<render::RenderTargets> targets;
    const render::GlFunctions* functions;
    render::SceneRenderer scene;
    std::optional<render::IdBuffer> ids;  // made when layers are asked for
    std::uint64_t layers_drawn = 0;
    std::optional<Panels> made_panels;
    panels::FrameLayout layout;
    render::Camera camera;
};

FramePainter::FramePainter(const Story& story, int width, int height, const FrameLook& look)
    : story_(&story),
      look_(look),
      style_(picture_style(story)),
      surface_(std::make_unique<Surface>(width, height, look, characters_of(story))) {
    compose_camera();
}

FramePainter::FramePainter(const Story& story, int width, int height, const render::GlFunctions& gl)
    : story_(&story),
      style_(picture_style(story)),
      surface_(std::make_unique<Surface>(width, height, characters_of(story), gl)) {
    compose_camera();
}

FramePainter::~FramePainter() = default;

void FramePainter::compose_camera() {
    // ImGui has one current context for all threads: another one comes back when the letters are there
    if (surface_->context.is_above_another()) { surface_->panels(); }
    surface_->context.leave();
    surface_->camera = camera_of(*story_, style_, surface_->layout.scene, surface_->layout.scene_safe);
}

void FramePainter::wait_for_fonts() {
    Surface& s = *surface_;
    s.context.enter();
    s.make_current();
    s.panels();
    s.context.leave();
}

const render::Camera& FramePainter::camera() const { return surface_->camera; }

Picture FramePainter::picture(const View& view) const {
    return picture(view, story_->steps()[static_cast<std::size_t>(view.step)]);
}

Picture FramePainter::picture(const View& view, const Step& step) const {
    Picture picture = picture_of(*story_, style_, step, view.step);
    light_up(picture, lit_at(view));
    return picture;
}

Emphasis FramePainter::lit_at(const View& view) const {
    Emphasis lit;
    light_answer(
        story_->steps()[static_cast<std::size_t>(view.step)], story_->lesson().coordinates, view, lit);
    return lit;
}

render::Image FramePainter::paint(const View& view) { return paint(view, picture(view)); }

render::Image FramePainter::paint(const View& view, const Picture& picture, const OnPaintStage& ended) {
    return paint(view, picture, lit_at(view), ended);
}

render::Image FramePainter::paint_numbered(View view, const Picture& picture, int step, int steps) {
    // of the step itself: the story may have none of that number
    const Emphasis lit = lit_at(view);
    view.step = step;
    view.steps = steps;
    return paint(view, picture, lit, {});
}

void FramePainter::draw_scene(const Picture& picture) {
    Surface& s = *surface_;
    if (look_.is_opaque) {
        s.begin_3d(toned(render::palette::kPaper, look_.tone));
        s.scene.draw(picture.scene, s.camera, s.layout.scene, s.drawn_into(), look_.tone);
        return;
    }
    s.begin_3d(kNothing);
    render::Scene scene = picture.scene;
    scene.ground.reset();
    s.scene.draw(scene, s.camera, s.layout.scene, s.drawn_into(), look_.tone, render::Backdrop::paper);
}

void FramePainter::draw_panels(const View& view, const Picture& picture, const Emphasis& lit) {
    Surface& s = *surface_;
    Surface::Panels& ready = s.panels();
    ImGui::NewFrame();
    std::vector<panels::HotSpot> nowhere;
    const panels::Canvas canvas =
        panels::Canvas(ImGui::GetBackgroundDrawList(), ready.fonts).pointed(lit, nowhere).in(look_.tone);
    if (look_.has_panels) {
        panels::draw_frame(canvas, view, picture, s.camera, s.layout);
    } else {
        panels::draw_annotations(canvas, picture, s.camera, s.layout.scene);
    }
    ImGui::Render();
    ready.backend.draw(*ImGui::GetDrawData(), s.size());
}

render::Image FramePainter::paint(
    const View& view, const Picture& picture, const Emphasis& lit, const OnPaintStage& ended) {
    Surface& s = *surface_;
    const auto end = [&](PaintStage stage) {
        if (!ended) { return; }
        s.functions->Finish();
        ended(stage);
    };
    s.context.enter();
    s.make_current();
    if (ended) { s.scene.draw_shadows(picture.scene, s.camera, s.layout.scene, s.size()); }
    end(PaintStage::shadow);
    draw_scene(picture);
    s.begin_2d();
    end(PaintStage::scene);
    draw_panels(view, picture, lit);
    end(PaintStage::panels);
    s.context.leave();
    render::Image image = s.read(look_.is_opaque);
    end(PaintStage::read);
    return image;
}

std::vector<std::uint8_t> FramePainter::vector_file(const View& view, render::VectorFormat format) {
    Surface& s = *surface_;
    const Picture shown = picture(view);
    const render::Rect& scene = s.layout.scene;
    const auto width = static_cast<int>(std::lround(kSharper * scene.width));
    const auto height = static_cast<int>(std::lround(kSharper * scene.height));
    s.make_current();
    render::RenderTargets large(*s.functions, width, height);
    large.begin_3d();
    s.scene.draw(shown.scene, s.camera, {0.0, 0.0, scene.width * kSharper, scene.height * kSharper}, large);
    large.begin_2d();
    const render::Image solid = large.read();

    render::VectorPicture file(format, s.size().width, s.size().height);
    file.fill({}, s.size().width, s.size().height, render::palette::kPaper);
    file.image(solid, {scene.x, scene.y}, scene.width, scene.height);
    s.context.enter();
    const render::Fonts& fonts = s.panels().fonts;
    VectorStrokes strokes(file, fonts);
    std::vector<panels::HotSpot> nowhere;
    const panels::Canvas canvas(strokes, fonts);
    panels::draw_frame(canvas.pointed(lit_at(view), nowhere), view, shown, s.camera, s.layout);
    s.context.leave();
    return file.finish();
}

std::string FramePainter::renderer() const { return render::renderer_name(*surface_->functions); }

render::PictureLayers FramePainter::layers(const Picture& picture) {
    Surface& s = *surface_;
    s.make_current();
    if (!s.ids) { s.ids.emplace(*s.functions, s.scene.meshes()); }
    s.ids->update(
        picture.scene, s.camera, s.layout.scene, s.size(), ++s.layers_drawn,
        render::SceneView::Details::full);
    return s.ids->read_layers();
}

}  // namespace jw::host
