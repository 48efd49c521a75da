#pragma once

#include <imgui.h>

#include "render/files/image.hpp"
#include "render/gl/gl_objects.hpp"
#include "render/scene/camera.hpp"

struct ImDrawData;

namespace jw::render {

/// Draws panels: the draw data of ImGui through this program's table of GL functions. The backend that comes
/// with ImGui opens libGL itself, which does not know an OSMesa context.
class ImguiBackend {
public:
    /// Uploads the font atlas of the current ImGui context, built by `load_fonts`, and registers the features
    /// of this backend in the context. Context and `gl` must outlive this object.
    explicit ImguiBackend(const GlFunctions& gl);

    /// Uploads the atlas again, after `load_fonts` for another scale. Draw data that were made before show
    /// letters at wrong places of the new atlas, so load fonts before a frame begins.
    void reload_fonts();

    /// Draws into the bound framebuffer, over its content. Layout is in pixels of the frame; larger panels
    /// need larger fonts.
    /// @throws std::invalid_argument if the framebuffer scale of the data is not 1
    void draw(const ImDrawData& data, const FrameSize& frame) const;

    /// Draws a part of the frame; buffers of the size of this part must be bound. @throws as `draw`
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

/// A picture on the graphics card for `ImDrawList::AddImage`. Its top left corner is uv (0, 0). Colours are
/// interpolated between pixels, so it is sharpest at its own size.
class PictureTexture {
public:
    /// The context must be current here and at destruction; `gl` must outlive this object.
    /// @throws std::invalid_argument if the picture is empty or its size does not match its data
    PictureTexture(const GlFunctions& gl, const Image& image);

    /// Valid as long as this object exists: draw everything that shows the picture before that.
    ImTextureID id() const;

private:
    GlTexture texture_;
};

}  // namespace jw::render
