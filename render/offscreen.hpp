#pragma once

#include <memory>
#include <string>

#include "render/frame_size.hpp"
#include "render/gl_functions.hpp"
#include "render/image.hpp"

namespace jw::render {

/// A picture without a window: an OSMesa context and a framebuffer to draw in.
///
/// One frame is `begin_3d`, draw bodies, `begin_2d`, draw panels, `read`. Panels go into the resolved
/// picture, so text is not multisampled: faster and as sharp.
class Offscreen {
public:
    /// @param samples  wanted per pixel; without multisampling the picture is drawn at double size instead
    /// @throws std::runtime_error if there is no software GL 3.3 or the size is out of its range.
    Offscreen(int width, int height, int samples = 4);
    ~Offscreen();
    Offscreen(const Offscreen&) = delete;
    Offscreen& operator=(const Offscreen&) = delete;

    const GlFunctions& gl() const;
    FrameSize size() const;

    /// What draws: e.g. "llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Core Profile) Mesa 22.3.6".
    std::string renderer() const;

    /// Samples per pixel in effect; 1 if drawn at double size.
    int samples() const;

    /// Makes the context current and clears the multisampled framebuffer.
    void begin_3d();

    /// Resolves what was drawn and binds the flat framebuffer for panels and text.
    void begin_2d();

    /// The picture, top row first.
    /// @throws std::runtime_error if GL reported an error since the last call.
    Image read();

private:
    struct Context;
    struct Targets;
    std::unique_ptr<Context> context_;
    std::unique_ptr<Targets> targets_;
};

}  // namespace jw::render
