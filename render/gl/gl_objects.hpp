#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include <Eigen/Core>

#include "render/gl/gl_functions.hpp"
#include "render/scene/camera.hpp"
#include "render/scene/palette.hpp"

/// Owners of GL objects. The context in which they were made must be current when they are destroyed.
namespace jw::render {

/// Rectangle in pixels of the device, counted from the bottom as in GL.
struct DeviceRect {
    int x, y;
    int width, height;

    bool empty() const { return width < 1 || height < 1; }
    bool operator==(const DeviceRect&) const = default;
};

DeviceRect device_rect(const Rect& rect, const FrameSize& frame);

/// A rectangle of the frame in the coordinates of a part's buffers; it may extend beyond them.
DeviceRect device_rect(const Rect& rect, const FrameSize& frame, const FramePart& part);

/// All pixels of the buffers of a part.
DeviceRect device_rect(const FramePart& part, const FrameSize& frame);

/// Pixels of `rect` that lie in the buffers of `part`.
DeviceRect shown_rect(const Rect& rect, const FrameSize& frame, const FramePart& part);

/// Intersection; empty if the two do not overlap.
DeviceRect common_part(const DeviceRect& a, const DeviceRect& b);

/// One GL name, deleted with its owner by the function that `Delete` names in the table.
template <auto Delete>
class GlObject {
public:
    GlObject() = default;
    GlObject(const GlFunctions& gl, GLuint name) : gl_(&gl), name_(name) {}
    GlObject(GlObject&& other) noexcept
        : gl_(std::exchange(other.gl_, nullptr)), name_(std::exchange(other.name_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept {
        std::swap(gl_, other.gl_);
        std::swap(name_, other.name_);
        return *this;
    }
    GlObject(const GlObject&) = delete;
    GlObject& operator=(const GlObject&) = delete;
    ~GlObject() {
        if (gl_ == nullptr || name_ == 0) { return; }
        if constexpr (std::is_invocable_v<decltype(gl_->*Delete), GLuint>) {
            (gl_->*Delete)(name_);
        } else {
            (gl_->*Delete)(1, &name_);
        }
    }

    GLuint name() const { return name_; }

private:
    const GlFunctions* gl_ = nullptr;
    GLuint name_ = 0;
};

/// An object whose name the function `Generate` of the table makes.
template <auto Generate, auto Delete>
class GlGenerated : public GlObject<Delete> {
public:
    using GlObject<Delete>::GlObject;
    static GlGenerated make(const GlFunctions& gl) {
        GLuint name = 0;
        (gl.*Generate)(1, &name);
        return GlGenerated(gl, name);
    }
};

using GlBuffer = GlGenerated<&GlFunctions::GenBuffers, &GlFunctions::DeleteBuffers>;
using GlFramebuffer = GlGenerated<&GlFunctions::GenFramebuffers, &GlFunctions::DeleteFramebuffers>;
using GlRenderbuffer = GlGenerated<&GlFunctions::GenRenderbuffers, &GlFunctions::DeleteRenderbuffers>;
using GlShader = GlObject<&GlFunctions::DeleteShader>;
using GlTexture = GlGenerated<&GlFunctions::GenTextures, &GlFunctions::DeleteTextures>;
using GlVertexArray = GlGenerated<&GlFunctions::GenVertexArrays, &GlFunctions::DeleteVertexArrays>;

/// A new renderbuffer, attached to the bound framebuffer.
GlRenderbuffer attached_renderbuffer(
    const GlFunctions& gl, GLenum format, GLenum attachment, int samples, int width, int height);

/// Binds a framebuffer and, when destroyed, the one that was bound before.
class BoundFramebuffer {
public:
    BoundFramebuffer(const GlFunctions& gl, const GlFramebuffer& framebuffer) : gl_(gl) {
        gl_.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before_);
        gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    }
    ~BoundFramebuffer() { gl_.BindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(before_)); }
    BoundFramebuffer(const BoundFramebuffer&) = delete;
    BoundFramebuffer& operator=(const BoundFramebuffer&) = delete;

private:
    const GlFunctions& gl_;
    GLint before_ = 0;
};

/// Copies a part of a framebuffer into the bound one, of the same size; several samples are averaged.
void copy_part(const GlFunctions& gl, const GlFramebuffer& from, const DeviceRect& part);

/// A linked pair of shaders and its uniforms by name.
class GlProgram {
public:
    /// @param title  names the program in errors
    /// @throws std::runtime_error with the log of the compiler.
    GlProgram(
        const GlFunctions& gl, std::string_view title, std::string_view vertex, std::string_view fragment);

    void use() const { gl_->UseProgram(program_.name()); }

    // the program must be in use
    void set(const char* uniform, int value) const;
    void set(const char* uniform, float value) const;
    void set(const char* uniform, float x, float y) const;
    void set(const char* uniform, const Eigen::Vector3d& value) const;
    void set(const char* uniform, const Eigen::Matrix4d& value) const;
    void set(const char* uniform, const Colour& value) const;

private:
    GLint location(const char* uniform) const { return gl_->GetUniformLocation(program_.name(), uniform); }

    const GlFunctions* gl_;
    GlObject<&GlFunctions::DeleteProgram> program_;
};

}  // namespace jw::render
