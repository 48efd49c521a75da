#include "jointwise/picture.hpp"

#include <algorithm>

#include "app/session/picture/still.hpp"
#include "library/convert.hpp"
#include "library/inside.hpp"
#include "library/inside_lesson.hpp"
#include "render/files/atomic_file.hpp"
#include "render/files/png.hpp"
#include "render/passes/scene_renderer.hpp"
#include "render/surface/offscreen.hpp"

namespace jointwise {
inline namespace JOINTWISE_ABI {

namespace {

/// Share of the smaller side that stays free around the mechanism.
constexpr double kMargin = 0.08;

/// The lesson at rest in a pose: all joints are present, and neither drivers nor a motion move it.
jw::Lesson still_of(jw::Lesson lesson, const Pose& pose) {
    const jw::State state = state_of(lesson.mechanism, pose);
    for (std::size_t b = 0; b < lesson.mechanism.bodies.size(); ++b) {
        lesson.mechanism.bodies[b].r = state.r[b];
        lesson.mechanism.bodies[b].p = state.p[b];
    }
    const std::vector<int> thetas = lesson.mechanism.theta_indices();
    for (std::size_t j = 0; j < thetas.size(); ++j) {
        if (thetas[j] < 0) { continue; }
        lesson.mechanism.joints[j].geometry.theta_start = state.theta[static_cast<std::size_t>(thetas[j])];
    }
    // a driver has its value only at its own time; texts and questions about it are removed, too
    lesson.mechanism.drivers.clear();
    lesson.motion.reset();
    lesson.dynamics.reset();
    return lesson;
}

Image drawn(const jw::Lesson& lesson, int width, int height) {
    namespace render = jw::render;
    const jw::Still still(lesson, true);
    const render::Rect all{0.0, 0.0, static_cast<double>(width), static_cast<double>(height)};
    const render::Rect safe = render::shrunk(all, kMargin * std::min(width, height));
    render::Offscreen surface(width, height);
    const render::SceneRenderer renderer(surface.gl());
    surface.begin_3d();
    renderer.draw(still.picture().scene, still.camera(all, safe), all, surface.targets());
    surface.begin_2d();  // merges the samples of each pixel
    render::Image image = surface.read();
    return {image.width, image.height, std::move(image.rgb)};
}

}  // namespace

Image draw(const Mechanism& mechanism, const Pose& pose, int width, int height) {
    jw::Lesson lesson;
    lesson.mechanism = mechanism.inside().mechanism;
    lesson.looks.resize(lesson.mechanism.bodies.size());
    return drawn(still_of(std::move(lesson), pose), width, height);
}

Image draw(const Lesson& lesson, const Pose& pose, int width, int height) {
    return drawn(still_of(lesson.inside().lesson, pose), width, height);
}

std::vector<std::uint8_t> png_of(const Image& image) {
    return jw::render::encode_png({image.width, image.height, image.rgb});
}

void write_png(const Image& image, const std::filesystem::path& file) {
    jw::render::write_file_atomically(file, png_of(image));
}

}  // namespace JOINTWISE_ABI
}  // namespace jointwise
