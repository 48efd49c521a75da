#pragma once

#include "render/frame_size.hpp"
#include "render/gl_objects.hpp"

struct ImDrawData;

namespace jw::render {

/// Draws panels: the draw data of ImGui through our table of GL functions. The backend that comes with ImGui
/// opens libGL by itself, which knows nothing of an OSMesa context.
class ImguiBackend {
public:
    /// Uploads the font atlas of the current ImGui context, built by `load_fonts`, and tells the context what
    /// this backend can do. Context and `gl` must outlive this.
    explicit ImguiBackend(const GlFunctions& gl);

    /// Draws into the framebuffer that is bound, over what it shows.
    void draw(const ImDrawData& data, const FrameSize& frame) const;

private:
    void set_state(const ImDrawData& data, const FrameSize& frame) const;

    const GlFunctions& gl_;
    GlProgram program_;
    GlVertexArray array_;
    GlBuffer vertices_;
    GlBuffer indices_;
    GlTexture font_;
};

}  // namespace jw::render
