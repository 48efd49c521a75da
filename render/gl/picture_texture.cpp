#include "render/gl/picture_texture.hpp"

#include <stdexcept>
#include <string>

#include "render/gl/texture_id.hpp"

namespace jw::render {
namespace {

GlTexture upload(const GlFunctions& gl, const Image& image) {
    const bool empty = image.width < 1 || image.height < 1;
    if (empty || image.rgb.size() !=
                     3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height)) {
        throw std::invalid_argument(
            "a picture of " + std::to_string(image.width) + " x " + std::to_string(image.height) +
            " pixels cannot have " + std::to_string(image.rgb.size()) + " bytes");
    }
    GlTexture texture = make_texture(gl);
    gl.BindTexture(GL_TEXTURE_2D, texture.name());
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.TexImage2D(
        GL_TEXTURE_2D, 0, GL_RGB8, image.width, image.height, 0, GL_RGB, GL_UNSIGNED_BYTE, image.rgb.data());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    // the left edge must not blend with the right one
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

}  // namespace

PictureTexture::PictureTexture(const GlFunctions& gl, const Image& image)
    : width_(image.width), height_(image.height), texture_(upload(gl, image)) {}

ImTextureID PictureTexture::id() const { return texture_id_cast<ImTextureID>(texture_.name()); }

}  // namespace jw::render
