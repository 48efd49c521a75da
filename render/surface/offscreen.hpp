#pragma once

#include <memory>
#include <string>

#include "render/files/image.hpp"
#include "render/gl/gl_functions.hpp"
#include "render/gl/render_targets.hpp"
#include "render/scene/camera.hpp"
#include "render/scene/palette.hpp"

namespace jw::render {

class HeadlessContext;

/// A picture without a window: a context of OSMesa or EGL with `RenderTargets`; see there how to draw frames.
///
/// Several may exist at once. Other objects made with `gl` (renderers, textures) must be destroyed while this
/// context is current: call `make_current` where another context may have been used since.
class Offscreen {
public:
    /// @param samples  see `RenderTargets`
    /// @throws std::runtime_error if there is no software GL 3.3 or the size is out of range.
    Offscreen(int width, int height, int samples = 4);
    ~Offscreen();
    Offscreen(const Offscreen&) = delete;
    Offscreen& operator=(const Offscreen&) = delete;

    const GlFunctions& gl() const;
    FrameSize size() const;

    /// Name of the renderer, such as "llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Core Profile) Mesa 22.3.6".
    std::string renderer() const;

    /// From now on, pictures have another size; programs, meshes and fonts of the context stay.
    /// @throws std::runtime_error if the size is out of range; then the old size stays.
    void resize(int width, int height);

    void make_current() const;

    /// Targets for `SceneRenderer::draw`. The context must be current.
    RenderTargets& targets() const { return *targets_; }

    // these make the context current
    void begin_3d(const Colour& paper = palette::kPaper);
    void begin_2d();
    Image read(bool is_opaque = true);

private:
    std::unique_ptr<HeadlessContext> context_;
    int wanted_samples_;
    std::unique_ptr<RenderTargets> targets_;
};

}  // namespace jw::render
