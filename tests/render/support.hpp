#pragma once

#include <filesystem>
#include <random>
#include <string>

#include <unistd.h>

#include <Eigen/Core>

#include "render/camera.hpp"
#include "render/image.hpp"
#include "render/offscreen.hpp"
#include "render/scene.hpp"
#include "render/scene_renderer.hpp"

/// What several tests of the renderer need.
namespace jw::render::test {

inline Vector3d random_vector(std::mt19937& random, double size) {
    std::uniform_real_distribution<double> uniform(-size, size);
    const double x = uniform(random);
    const double y = uniform(random);
    return {x, y, uniform(random)};
}

/// A folder of its own, removed with everything in it.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "jointwise-test-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) { throw std::runtime_error("no temporary folder"); }
        path_ = name;
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }

    const std::filesystem::path& path() const { return path_; }
    std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(std::filesystem::directory_iterator(path_), std::filesystem::directory_iterator()));
    }

private:
    std::filesystem::path path_;
};

/// The picture of a scene, with a context of its own.
inline Image picture(const Scene& scene, const Camera& camera, const Rect& viewport, int width, int height) {
    Offscreen offscreen(width, height);
    const SceneRenderer renderer(offscreen.gl());
    offscreen.begin_3d();
    renderer.draw(scene, camera, viewport, offscreen.size());
    offscreen.begin_2d();
    return offscreen.read();
}

}  // namespace jw::render::test
