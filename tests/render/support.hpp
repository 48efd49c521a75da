#pragma once

#include <random>
#include <string>

#include <Eigen/Core>

#include "render/files/image.hpp"
#include "render/passes/scene_renderer.hpp"
#include "render/scene/camera.hpp"
#include "render/scene/scene.hpp"
#include "render/surface/offscreen.hpp"
#include "tests/support/temporary_folder.hpp"

/// Parts shared by several tests of the renderer.
namespace jw::render::test {

inline Vector3d random_vector(std::mt19937& random, double size) {
    std::uniform_real_distribution<double> uniform(-size, size);
    const double x = uniform(random);
    const double y = uniform(random);
    return {x, y, uniform(random)};
}

using jw::test::TemporaryFolder;

/// The picture of a scene, with a context of its own.
inline Image picture(const Scene& scene, const Camera& camera, const Rect& viewport, int width, int height) {
    Offscreen offscreen(width, height);
    const SceneRenderer renderer(offscreen.gl());
    offscreen.begin_3d();
    renderer.draw(scene, camera, viewport, offscreen.targets());
    offscreen.begin_2d();
    return offscreen.read();
}

}  // namespace jw::render::test
