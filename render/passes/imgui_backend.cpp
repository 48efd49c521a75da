#include "render/passes/imgui_backend.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

#include <imgui.h>

namespace jw::render {

namespace {

constexpr const char* kVertexShader = R"(
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 colour;
uniform mat4 clip_from_picture;
out vec2 texel;
out vec4 tint;

void main() {
    texel = uv;
    tint = colour;
    gl_Position = clip_from_picture * vec4(position, 0.0, 1.0);
}
)";

constexpr const char* kFragmentShader = R"(
in vec2 texel;
in vec4 tint;
uniform sampler2D picture;
uniform bool coverage;  // the texture holds only that: white of this opacity
out vec4 pixel;

void main() {
    vec4 read = texture(picture, texel);
    pixel = tint * (coverage ? vec4(1.0, 1.0, 1.0, read.r) : read);
}
)";

/// Id of the font atlas in draw data: the one that ImGui gives to an atlas without a texture, and that no GL
/// texture has. So draw data stay valid when the atlas is uploaded again under another name.
constexpr GLuint kAtlas = 0;

/// The atlas contains only coverage.
GlTexture upload_atlas(const GlFunctions& gl, ImFontAtlas& atlas) {
    unsigned char* texels = nullptr;
    int width = 0;
    int height = 0;
    atlas.GetTexDataAsAlpha8(&texels, &width, &height);
    auto texture = GlTexture::make(gl);
    gl.BindTexture(GL_TEXTURE_2D, texture.name());
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, width, height, 0, GL_RED, GL_UNSIGNED_BYTE, texels);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    return texture;
}

Eigen::Matrix4d clip_from_picture(const ImDrawData& data) {
    Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
    m(0, 0) = 2.0 / static_cast<double>(data.DisplaySize.x);
    m(1, 1) = -2.0 / static_cast<double>(data.DisplaySize.y);
    m(0, 3) = -1.0 - static_cast<double>(data.DisplayPos.x) * m(0, 0);
    m(1, 3) = 1.0 - static_cast<double>(data.DisplayPos.y) * m(1, 1);
    return m;
}

/// Reads vertices from number `first` on: indices of ImGui are small, and count from there.
void point_at_vertices(const GlFunctions& gl, std::size_t first) {
    constexpr auto stride = static_cast<GLsizei>(sizeof(ImDrawVert));
    const auto at = [first](std::size_t offset) {
        return reinterpret_cast<const void*>(first * sizeof(ImDrawVert) + offset);
    };
    gl.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, stride, at(offsetof(ImDrawVert, pos)));
    gl.VertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, stride, at(offsetof(ImDrawVert, uv)));
    gl.VertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride, at(offsetof(ImDrawVert, col)));
}

/// Sets GL's scissor, which counts pixels from the bottom. @return false if nothing is left to draw into
bool set_scissor(const GlFunctions& gl, const ImVec4& clip, const ImDrawData& data, const FrameSize& frame) {
    const auto ratio = static_cast<float>(frame.pixel_ratio);
    const auto pixels = [ratio](float length) { return static_cast<GLint>(std::lround(length * ratio)); };
    const GLint left = std::max(pixels(clip.x - data.DisplayPos.x), 0);
    const GLint top = std::max(pixels(clip.y - data.DisplayPos.y), 0);
    const GLint right = std::min(pixels(clip.z - data.DisplayPos.x), frame.width * frame.pixel_ratio);
    const GLint bottom = std::min(pixels(clip.w - data.DisplayPos.y), frame.height * frame.pixel_ratio);
    if (right <= left || bottom <= top) { return false; }
    gl.Scissor(left, frame.height * frame.pixel_ratio - bottom, right - left, bottom - top);
    return true;
}

GlTexture upload(const GlFunctions& gl, const Image& image) {
    const bool empty = image.width < 1 || image.height < 1;
    if (empty || image.rgb.size() !=
                     3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height)) {
        throw std::invalid_argument(
            "a picture of " + std::to_string(image.width) + " x " + std::to_string(image.height) +
            " pixels cannot have " + std::to_string(image.rgb.size()) + " bytes");
    }
    auto texture = GlTexture::make(gl);
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

ImguiBackend::ImguiBackend(const GlFunctions& gl)
    : gl_(gl),
      program_(gl, "panels", kVertexShader, kFragmentShader),
      array_(GlVertexArray::make(gl)),
      vertices_(GlBuffer::make(gl)),
      indices_(GlBuffer::make(gl)) {
    reload_fonts();
    ImGuiIO& io = ImGui::GetIO();
    io.BackendRendererName = "jointwise";
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;

    gl_.BindVertexArray(array_.name());
    gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
    for (const GLuint location : {0U, 1U, 2U}) { gl_.EnableVertexAttribArray(location); }
    gl_.BindVertexArray(0);
}

void ImguiBackend::reload_fonts() { font_ = upload_atlas(gl_, *ImGui::GetIO().Fonts); }

void ImguiBackend::draw(const ImDrawData& data, const FrameSize& frame) const {
    if (data.FramebufferScale.x != 1.0F || data.FramebufferScale.y != 1.0F) {
        throw std::invalid_argument("panels are laid out in pixels of the frame: the framebuffer scale is 1");
    }
    if (data.DisplaySize.x <= 0.0F || data.DisplaySize.y <= 0.0F) { return; }
    set_state(data, frame);
    constexpr GLenum index_type = sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
    for (int n = 0; n < data.CmdListsCount; ++n) {
        const ImDrawList& list = *data.CmdLists[n];
        gl_.BufferData(GL_ARRAY_BUFFER, list.VtxBuffer.size_in_bytes(), list.VtxBuffer.Data, GL_STREAM_DRAW);
        gl_.BufferData(
            GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer.size_in_bytes(), list.IdxBuffer.Data, GL_STREAM_DRAW);
        for (const ImDrawCmd& command : list.CmdBuffer) {
            if (command.UserCallback != nullptr) {
                // a callback may have changed the state
                if (command.UserCallback != ImDrawCallback_ResetRenderState) {
                    command.UserCallback(&list, &command);
                }
                set_state(data, frame);
                continue;
            }
            if (!set_scissor(gl_, command.ClipRect, data, frame)) { continue; }
            const GLuint name = static_cast<GLuint>(std::bit_cast<std::uintptr_t>(command.GetTexID()));
            gl_.BindTexture(GL_TEXTURE_2D, name == kAtlas ? font_.name() : name);
            program_.set("coverage", name == kAtlas ? 1 : 0);
            point_at_vertices(gl_, command.VtxOffset);
            gl_.DrawElements(
                GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount), index_type,
                reinterpret_cast<const void*>(command.IdxOffset * sizeof(ImDrawIdx)));
        }
    }
    gl_.Disable(GL_SCISSOR_TEST);
    gl_.Disable(GL_BLEND);
    gl_.BindVertexArray(0);
}

void ImguiBackend::draw(const ImDrawData& data, const FrameSize& frame, const FramePart& part) const {
    // a copy has only pointers to the lists
    ImDrawData shifted = data;
    shifted.DisplayPos.x += static_cast<float>(part.x);
    shifted.DisplayPos.y += static_cast<float>(part.y);
    shifted.DisplaySize = {static_cast<float>(part.width), static_cast<float>(part.height)};
    draw(shifted, {part.width, part.height, frame.pixel_ratio});
}

void ImguiBackend::set_state(const ImDrawData& data, const FrameSize& frame) const {
    gl_.Viewport(0, 0, frame.width * frame.pixel_ratio, frame.height * frame.pixel_ratio);
    gl_.Enable(GL_BLEND);
    gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl_.Enable(GL_SCISSOR_TEST);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Disable(GL_CULL_FACE);
    gl_.ActiveTexture(GL_TEXTURE0);
    program_.use();
    program_.set("clip_from_picture", clip_from_picture(data));
    program_.set("picture", 0);
    gl_.BindVertexArray(array_.name());
    gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
}

PictureTexture::PictureTexture(const GlFunctions& gl, const Image& image) : texture_(upload(gl, image)) {}

ImTextureID PictureTexture::id() const { return std::bit_cast<ImTextureID>(std::uintptr_t{texture_.name()}); }

}  // namespace jw::render
