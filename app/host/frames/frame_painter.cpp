#include "app/host/frames/frame_painter.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include <imgui.h>

#include "app/host/frames/panel_context.hpp"
#include "app/host/frames/vector_strokes.hpp"
#include "app/panels/frame/annotations.hpp"
#include "app/panels/frame/frame.hpp"
#include "app/panels/parts/characters.hpp"
#include "app/session/background/background.hpp"
#include "app/session/picture/picture.hpp"
#include "app/session/picture/pointable.hpp"
#include "render/fonts/fonts.hpp"
#include "render/gl/render_targets.hpp"
#include "render/passes/id_buffer.hpp"
#include "render/passes/imgui_backend.hpp"
#include "render/passes/scene_renderer.hpp"
#include "render/surface/mesa_settings.hpp"
#include "render/surface/offscreen.hpp"

namespace jw::host {

namespace {

/// Resolution of the 3D part of a vector picture, relative to the frame.
constexpr double kSharper = 2.0;
// background of a transparent picture
constexpr render::Colour kNothing{0.0F, 0.0F, 0.0F, 0.0F};

std::u32string characters_of(const Story& story) {
    return panels::characters_of(story.lesson()) + panels::characters_of_messages();
}

/// Fonts, loaded while this thread draws the first scene: each of the two takes a third of the time until
/// the first picture.
using LoadingFonts = std::unique_ptr<Background<render::Fonts>>;
LoadingFonts fonts_for(int width, int height, const FrameLook& look, const std::u32string& characters) {
    return std::make_unique<Background<render::Fonts>>(
        [scale = look.scale(width, height), characters](const std::stop_token&) {
            return std::optional(render::load_fonts(scale, characters));
        });
}

/// As fonts_for, after setting the environment for Mesa: it must not change while the thread reads it.
LoadingFonts fonts_before_mesa(
    int width, int height, const FrameLook& look, const std::u32string& characters) {
    render::settle_mesa();
    return fonts_for(width, height, look, characters);
}

panels::FrameLayout layout_for(int width, int height, const FrameLook& look) {
    const panels::Box frame{0.0F, 0.0F, static_cast<float>(width), static_cast<float>(height)};
    const float scale = look.scale(width, height);
    return look.has_panels ? panels::layout_in(frame, panels::FrameKind::picture, scale)
                           : panels::layout_without_panels(frame, scale);
}

/// The first tile of a frame; all tiles have its size.
render::FramePart tile_of(int width, int height, int largest_width) {
    const int wide = std::min(width, largest_width);
    const std::int64_t pixels = std::int64_t{largest_width} * largest_width * 9 / 16;
    return {0, 0, wide, static_cast<int>(std::min<std::int64_t>(height, pixels / wide))};
}

/// Copies a tile to its place in a picture. For the first tile, the picture gets the size of the frame.
void put(
    const render::Image& part, const render::FramePart& tile, const render::FrameSize& frame,
    render::Image& image) {
    const auto pixels = [](int count) { return static_cast<std::size_t>(count); };
    if (image.rgb.empty()) {
        const std::size_t all = pixels(frame.width) * pixels(frame.height);
        image = {frame.width, frame.height, std::vector<std::uint8_t>(3 * all)};
        if (!part.alpha.empty()) { image.alpha.resize(all); }
    }
    const auto copy = [&](const std::vector<std::uint8_t>& from, std::vector<std::uint8_t>& to,
                          int channels) {
        const std::size_t row = pixels(channels * tile.width);
        for (int y = 0; y < tile.height; ++y) {
            const std::size_t at = pixels(tile.y + y) * pixels(frame.width) + pixels(tile.x);
            std::copy_n(
                from.begin() + static_cast<std::ptrdiff_t>(pixels(y) * row), row,
                to.begin() + static_cast<std::ptrdiff_t>(pixels(channels) * at));
        }
    };
    copy(part.rgb, image.rgb, 3);
    if (!part.alpha.empty()) { copy(part.alpha, image.alpha, 1); }
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
          loading(fonts_before_mesa(width, height, look, characters)),
          frame{width, height, 1},
          tile(tile_of(width, height, look.tile_width)),
          offscreen(std::in_place, tile.width, tile.height),
          targets(offscreen->targets()),
          functions(offscreen->gl()),
          scene(functions),
          layout(layout_for(width, height, look)) {}
    Surface(int width, int height, const std::u32string& characters, const render::GlFunctions& gl)
        : context(width, height),
          loading(fonts_for(width, height, {}, characters)),
          frame{width, height, 1},
          tile{0, 0, width, height},
          own(std::in_place, gl, width, height),
          targets(*own),
          functions(gl),
          scene(gl),
          layout(layout_for(width, height, {})) {}

    /// Renderer of panels; waits for the fonts. ImGui's context must be current.
    /// @throws std::runtime_error if a font is missing
    Panels& panels() {
        if (!made_panels) { made_panels.emplace(loading->take(), functions); }
        return *made_panels;
    }

    /// Tiles that cover the frame. All are as large as the buffers, so the last ones overlap those before.
    std::vector<render::FramePart> tiles() const {
        std::vector<render::FramePart> all;
        for (int y = 0; y < frame.height; y += tile.height) {
            for (int x = 0; x < frame.width; x += tile.width) {
                all.push_back(tile);
                all.back().x = std::min(x, frame.width - tile.width);
                all.back().y = std::min(y, frame.height - tile.height);
            }
        }
        return all;
    }
    void make_current() const {
        if (offscreen) { offscreen->make_current(); }
    }

    PanelContext context;
    // uses the context above, which must not be used until the fonts are loaded, see `compose_camera`
    LoadingFonts loading;
    render::FrameSize frame;
    render::FramePart tile;  // the first one; all have its size
    // destroyed from the last to the first: owners of GL objects before their context
    std::optional<render::Offscreen> offscreen;
    std::optional<render::RenderTargets> own;
    render::RenderTargets& targets;
    const render::GlFunctions& functions;
    render::SceneRenderer scene;
    std::optional<render::IdBuffer> ids;  // created when layers are requested
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
    // ImGui has one current context for all threads: it may change back only when the fonts are loaded
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
    // taken from the step itself, because the story may not have a step of the new number
    const Emphasis lit = lit_at(view);
    view.step = step;
    view.steps = steps;
    return paint(view, picture, lit, {});
}

void FramePainter::draw_scene(const Picture& picture) {
    Surface& s = *surface_;
    if (look_.is_opaque) {
        s.targets.begin_3d(toned(render::palette::kPaper, look_.tone));
        s.scene.draw(picture.scene, s.camera, s.layout.scene, s.targets, look_.tone);
        return;
    }
    s.targets.begin_3d(kNothing);
    render::Scene scene = picture.scene;
    scene.ground.reset();
    s.scene.draw(scene, s.camera, s.layout.scene, s.targets, look_.tone, render::Backdrop::paper);
}

/// Lays out the panels as ImGui's draw data.
void FramePainter::lay_out_panels(const View& view, const Picture& picture, const Emphasis& lit) {
    Surface& s = *surface_;
    const render::Fonts& fonts = s.panels().fonts;
    ImGui::NewFrame();
    std::vector<panels::HotSpot> nowhere;
    const panels::Canvas canvas =
        panels::Canvas(ImGui::GetBackgroundDrawList(), fonts).pointed(lit, nowhere).in(look_.tone);
    if (look_.has_panels) {
        panels::draw_frame(canvas, view, picture, s.camera, s.layout);
    } else {
        panels::draw_annotations(canvas, picture, s.camera, s.layout.scene);
    }
    ImGui::Render();
}

render::Image FramePainter::paint(
    const View& view, const Picture& picture, const Emphasis& lit, const OnPaintStage& ended) {
    Surface& s = *surface_;
    const auto end = [&](PaintStage stage) {
        if (!ended) { return; }
        s.functions.Finish();
        ended(stage);
    };
    s.context.enter();
    s.make_current();
    if (ended) { s.scene.draw_shadows(picture.scene, s.camera, s.layout.scene, s.frame); }
    end(PaintStage::shadow);
    render::Image image;
    for (const render::FramePart& tile : s.tiles()) {
        const bool is_first = image.rgb.empty();
        s.targets.show_part(tile.x, tile.y, s.frame.width, s.frame.height);
        draw_scene(picture);
        s.targets.begin_2d();
        end(PaintStage::scene);
        // fonts have been loaded while the first scene was drawn
        if (is_first) { lay_out_panels(view, picture, lit); }
        s.panels().backend.draw(*ImGui::GetDrawData(), s.targets.size(), tile);
        end(PaintStage::panels);
        render::Image part = s.targets.read(look_.is_opaque);
        const bool is_all = part.width == s.frame.width && part.height == s.frame.height;
        if (is_all) {
            image = std::move(part);
        } else {
            put(part, tile, s.frame, image);
        }
        end(PaintStage::read);
    }
    s.context.leave();
    return image;
}

std::vector<std::uint8_t> FramePainter::vector_file(const View& view, render::VectorFormat format) {
    Surface& s = *surface_;
    const Picture shown = picture(view);
    const render::Rect& scene = s.layout.scene;
    const auto width = static_cast<int>(std::lround(kSharper * scene.width));
    const auto height = static_cast<int>(std::lround(kSharper * scene.height));
    s.make_current();
    render::RenderTargets large(s.functions, width, height);
    large.begin_3d();
    s.scene.draw(shown.scene, s.camera, {0.0, 0.0, scene.width * kSharper, scene.height * kSharper}, large);
    large.begin_2d();
    const render::Image solid = large.read();

    render::VectorPicture file(format, s.frame.width, s.frame.height);
    file.fill({}, s.frame.width, s.frame.height, render::palette::kPaper);
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

std::string FramePainter::renderer() const { return render::renderer_name(surface_->functions); }

render::PictureLayers FramePainter::layers(const Picture& picture) {
    Surface& s = *surface_;
    s.make_current();
    if (!s.ids) { s.ids.emplace(s.functions, s.scene.meshes()); }
    s.ids->update(
        picture.scene, s.camera, s.layout.scene, s.frame, ++s.layers_drawn, render::SceneView::Details::full);
    return s.ids->read_layers();
}

}  // namespace jw::host
