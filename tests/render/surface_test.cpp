#include <catch2/catch.hpp>

#include <memory>

#include "render/gl/render_targets.hpp"
#include "render/passes/id_buffer.hpp"
#include "render/scene/framing.hpp"
#include "render/surface/headless_context.hpp"
#include "tests/render/support.hpp"

namespace jw::render::test {
namespace {

Scene one_ball(const Colour& colour) {
    Scene scene;
    scene.ground = Ground{};
    scene.shapes.push_back({Sphere{{0.0, 0.0, 0.5}, 0.5}, colour});
    return scene;
}

const RenderTargets& targets_of(const Offscreen& offscreen) { return offscreen.targets(); }
const RenderTargets& targets_of(const RenderTargets& targets) { return targets; }

/// `Surface` is `Offscreen` or `RenderTargets`.
template <class Surface>
Image drawn(Surface& surface, const SceneRenderer& renderer, const Scene& scene) {
    const Rect whole{
        0.0, 0.0, static_cast<double>(surface.size().width), static_cast<double>(surface.size().height)};
    surface.begin_3d();
    renderer.draw(scene, frame_scene(bounds_of(scene), whole), whole, targets_of(surface));
    surface.begin_2d();
    return surface.read();
}

/// A surface with its renderer, which is destroyed first and in its own context.
struct Painter {
    Offscreen offscreen;
    std::unique_ptr<SceneRenderer> renderer;

    Painter(int width, int height)
        : offscreen(width, height), renderer(std::make_unique<SceneRenderer>(offscreen.gl())) {}
    ~Painter() {
        offscreen.make_current();
        renderer.reset();
    }
    Painter(const Painter&) = delete;
    Painter& operator=(const Painter&) = delete;

    Image paint(const Scene& scene) { return drawn(offscreen, *renderer, scene); }
};

Image alone(const Scene& scene, int width, int height) { return Painter(width, height).paint(scene); }

}  // namespace

TEST_CASE("OSMesa and EGL draw the same things at the same places", "[render][surface]") {
    const Scene scene = one_ball(palette::kOrange);
    const Rect whole{0.0, 0.0, 160.0, 90.0};
    std::vector<PictureLayers> layers;
    std::vector<Image> images;
    for (const HeadlessSurface surface : {HeadlessSurface::osmesa, HeadlessSurface::egl}) {
        choose_headless_surface(surface);
        Painter painter(160, 90);
        images.push_back(painter.paint(scene));
        IdBuffer ids(painter.offscreen.gl(), painter.renderer->meshes());
        ids.update(scene, frame_scene(bounds_of(scene), whole), whole, painter.offscreen.size(), 1);
        layers.push_back(ids.read_layers());
    }
    choose_headless_surface(HeadlessSurface::automatic);
    CHECK(layers[0] == layers[1]);
    // both are llvmpipe here; another renderer may shade a pixel differently
    CHECK(images[0] == images[1]);
}

TEST_CASE("OpenGL ES 3.0 draws what OpenGL 3.3 draws", "[render][surface]") {
    std::vector<Image> images;
    for (const GlProfile profile : {GlProfile::core_33, GlProfile::es_30}) {
        const std::unique_ptr<HeadlessContext> context = make_egl_context(profile);
        context->make_current();
        CHECK(context->gl().profile == profile);
        const SceneRenderer renderer(context->gl());
        RenderTargets targets(context->gl(), 464, 264);
        for (const Colour& colour : {palette::kOrange, palette::kBlue}) {
            images.push_back(drawn(targets, renderer, one_ball(colour)));
        }
    }
    CHECK(images[0] == images[2]);
    CHECK(images[1] == images[3]);
}

TEST_CASE("a surface that was resized draws what a new one of that size draws", "[render][surface]") {
    const Scene scene = one_ball(palette::kOrange);
    Painter painter(160, 90);
    const Image before = painter.paint(scene);
    painter.offscreen.resize(210, 131);
    CHECK(painter.paint(scene) == alone(scene, 210, 131));
    CHECK_THROWS_WITH(painter.offscreen.resize(0, 90), Catch::Contains("cannot be drawn"));
    CHECK(painter.offscreen.size().width == 210);
    painter.offscreen.resize(160, 90);
    CHECK(painter.paint(scene) == before);
}

TEST_CASE("two contexts draw in turns and neither disturbs the other", "[render][surface]") {
    const Scene orange = one_ball(palette::kOrange);
    const Scene blue = one_ball(palette::kBlue);
    const Image first = alone(orange, 160, 90);
    const Image second = alone(blue, 120, 80);
    CHECK_FALSE(alone(blue, 160, 90) == first);

    Painter one(160, 90);
    auto other = std::make_unique<Painter>(120, 80);
    CHECK(one.paint(orange) == first);
    CHECK(other->paint(blue) == second);
    one.offscreen.begin_3d();
    CHECK(other->paint(blue) == second);
    // left in the middle of a frame: paper and nothing else
    one.offscreen.begin_2d();
    const Image empty = one.offscreen.read();
    CHECK(std::equal(empty.rgb.begin() + 3, empty.rgb.end(), empty.rgb.begin()));
    other.reset();
    CHECK(one.paint(orange) == first);
}

TEST_CASE(
    "any context's targets give the picture of Offscreen, with 1 sample and with 4", "[render][surface]") {
    const Scene scene = one_ball(palette::kGreen);
    Painter painter(160, 90);
    const int samples = GENERATE(1, 4);
    Offscreen reference(160, 90, samples);
    const SceneRenderer renderer(reference.gl());
    const Image expected = drawn(reference, renderer, scene);

    painter.offscreen.make_current();
    RenderTargets targets(painter.offscreen.gl(), 160, 90, samples);
    const Image image = drawn(targets, *painter.renderer, scene);
    CHECK(image == expected);
    CHECK(targets.samples() == reference.targets().samples());
    reference.make_current();  // its renderer is destroyed first
}

TEST_CASE("one sample gives the same picture but for its borders", "[render][surface]") {
    const Scene scene = one_ball(palette::kVermilion);
    Painter painter(160, 90);
    const Image smooth = painter.paint(scene);
    RenderTargets targets(painter.offscreen.gl(), 160, 90, 1);
    const Image quick = drawn(targets, *painter.renderer, scene);
    int different = 0;
    for (std::size_t n = 0; n < smooth.rgb.size(); n += 3) {
        if (std::abs(smooth.rgb[n] - quick.rgb[n]) > 8) { ++different; }
    }
    // the outline of a ball some 60 pixels wide is 200 pixels long; its border touches one or two on each
    // side
    CHECK(different > 50);
    CHECK(different < 900);
}

TEST_CASE("a frame that begins with panels shows the bodies of the frame before", "[render][surface]") {
    const Scene scene = one_ball(palette::kSky);
    const int samples = GENERATE(1, 4);
    const Rect part{20.0, 10.0, 100.0, 70.0};
    Offscreen offscreen(160, 90, samples);
    const SceneRenderer renderer(offscreen.gl());
    offscreen.begin_3d();
    renderer.draw(scene, frame_scene(bounds_of(scene), part), part, offscreen.targets());
    offscreen.begin_2d();
    const Image first = offscreen.read();
    // something over all of it
    offscreen.gl().ClearColor(1.0F, 0.0F, 0.0F, 1.0F);
    offscreen.gl().Clear(GL_COLOR_BUFFER_BIT);
    CHECK_FALSE(offscreen.read() == first);
    offscreen.begin_2d();
    CHECK(offscreen.read() == first);
}

TEST_CASE("what is copied to the window is what a screenshot shows", "[render][surface]") {
    // the framebuffer of an OSMesa context is 16 x 16
    Painter painter(16, 16);
    const GlFunctions& gl = painter.offscreen.gl();
    RenderTargets targets(gl, 16, 16);
    const Image screenshot = drawn(targets, *painter.renderer, one_ball(palette::kPurple));
    targets.blit_to_window();
    std::vector<std::uint8_t> window(16 * 16 * 4);
    gl.ReadPixels(0, 0, 16, 16, GL_RGBA, GL_UNSIGNED_BYTE, window.data());
    CHECK(gl.GetError() == GL_NO_ERROR);
    int equal = 0;
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 16; ++x) {
            equal += std::equal(
                         screenshot.at(x, y), screenshot.at(x, y) + 3,
                         &window[static_cast<std::size_t>(4 * ((15 - y) * 16 + x))])
                         ? 1
                         : 0;
        }
    }
    CHECK(equal == 16 * 16);
}

}  // namespace jw::render::test
