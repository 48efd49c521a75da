#pragma once

#include <string>
#include <string_view>
#include <utility>

#include <Eigen/Core>

#include "render/gl/device_rect.hpp"
#include "render/gl/gl_functions.hpp"
#include "render/scene/palette.hpp"

/// Owners of GL objects. The context in which they were made must be current when they are destroyed.
namespace jw::render {

/// One GL name, deleted with its owner. `Delete` gets the table and the name.
template <void (*Delete)(const GlFunctions&, GLuint)>
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
        if (gl_ != nullptr && name_ != 0) { Delete(*gl_, name_); }
    }

    GLuint name() const { return name_; }

private:
    const GlFunctions* gl_ = nullptr;
    GLuint name_ = 0;
};

inline void delete_buffer(const GlFunctions& gl, GLuint name) { gl.DeleteBuffers(1, &name); }
inline void delete_framebuffer(const GlFunctions& gl, GLuint name) { gl.DeleteFramebuffers(1, &name); }
inline void delete_program(const GlFunctions& gl, GLuint name) { gl.DeleteProgram(name); }
inline void delete_renderbuffer(const GlFunctions& gl, GLuint name) { gl.DeleteRenderbuffers(1, &name); }
inline void delete_shader(const GlFunctions& gl, GLuint name) { gl.DeleteShader(name); }
inline void delete_texture(const GlFunctions& gl, GLuint name) { gl.DeleteTextures(1, &name); }
inline void delete_vertex_array(const GlFunctions& gl, GLuint name) { gl.DeleteVertexArrays(1, &name); }

using GlBuffer = GlObject<delete_buffer>;
using GlFramebuffer = GlObject<delete_framebuffer>;
using GlRenderbuffer = GlObject<delete_renderbuffer>;
using GlShader = GlObject<delete_shader>;
using GlTexture = GlObject<delete_texture>;
using GlVertexArray = GlObject<delete_vertex_array>;

GlBuffer make_buffer(const GlFunctions& gl);
GlFramebuffer make_framebuffer(const GlFunctions& gl);
GlRenderbuffer make_renderbuffer(const GlFunctions& gl);
GlTexture make_texture(const GlFunctions& gl);
GlVertexArray make_vertex_array(const GlFunctions& gl);

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
    GlObject<delete_program> program_;
};

}  // namespace jw::render
