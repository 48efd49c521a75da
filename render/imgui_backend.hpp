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

    /// Uploads the atlas again, after `load_fonts` for another scale. Draw data made before show the letters
    /// of the old atlas in wrong places: fonts are loaded before a frame begins.
    void reload_fonts();

    /// Draws into the framebuffer that is bound, over what it shows. Layout is in pixels of the frame; larger
    /// panels come with larger fonts.
    /// @throws std::invalid_argument if the data have a framebuffer scale other than 1
    void draw(const ImDrawData& data, const FrameSize& frame) const;

    /// Draws a part of the frame, for which buffers of its size are bound. @throws as `draw`
    void draw(const ImDrawData& data, const FrameSize& frame, const FramePart& part) const;

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
