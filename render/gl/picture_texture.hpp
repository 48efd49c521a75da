#pragma once

#include <imgui.h>

#include "render/files/image.hpp"
#include "render/gl/gl_objects.hpp"

namespace jw::render {

/// A picture on the graphics card for `ImDrawList::AddImage`. Its top left corner is uv (0, 0). Colours are
/// interpolated between pixels, so it is sharpest at its own size.
class PictureTexture {
public:
    /// The context must be current here and at destruction; `gl` must outlive this object.
    /// @throws std::invalid_argument if the picture is empty or its size does not match its data
    PictureTexture(const GlFunctions& gl, const Image& image);

    /// Valid as long as this object exists: draw everything that shows the picture before that.
    ImTextureID id() const;
    int width() const { return width_; }
    int height() const { return height_; }

private:
    int width_;
    int height_;
    GlTexture texture_;
};

}  // namespace jw::render
