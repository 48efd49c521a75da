#include "render/gl/gl_objects.hpp"

#include <stdexcept>

namespace jw::render {
namespace {

/// First lines of every shader.
const char* header_of(GlProfile profile) {
    switch (profile) {
        case GlProfile::core_33: return "#version 330 core\n";
        case GlProfile::es_30:
            return "#version 300 es\n"
                   "precision highp float;\n"
                   "precision highp int;\n"
                   "precision highp sampler2D;\n"
                   "precision highp sampler2DShadow;\n";
    }
    return "";
}

GlShader compile(const GlFunctions& gl, GLenum stage, std::string_view title, std::string_view source) {
    GlShader shader(gl, gl.CreateShader(stage));
    const std::string_view header = header_of(gl.profile);
    const char* const texts[] = {header.data(), source.data()};
    const GLint lengths[] = {static_cast<GLint>(header.size()), static_cast<GLint>(source.size())};
    gl.ShaderSource(shader.name(), 2, texts, lengths);
    gl.CompileShader(shader.name());
    GLint compiled = 0;
    gl.GetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
    if (compiled == 0) {
        std::string log(2000, '\0');
        GLsizei written = 0;
        gl.GetShaderInfoLog(shader.name(), static_cast<GLsizei>(log.size()), &written, log.data());
        log.resize(static_cast<std::size_t>(written));
        throw std::runtime_error("the graphics driver rejects shader '" + std::string(title) + "': " + log);
    }
    return shader;
}

void link(const GlFunctions& gl, GLuint program, std::string_view title) {
    gl.LinkProgram(program);
    GLint linked = 0;
    gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked == 0) {
        std::string log(2000, '\0');
        GLsizei written = 0;
        gl.GetProgramInfoLog(program, static_cast<GLsizei>(log.size()), &written, log.data());
        log.resize(static_cast<std::size_t>(written));
        throw std::runtime_error(
            "the graphics driver cannot link shader '" + std::string(title) + "': " + log);
    }
}

template <class Owner>
Owner generate(const GlFunctions& gl, void (*function)(GLsizei, GLuint*)) {
    GLuint name = 0;
    function(1, &name);
    return Owner(gl, name);
}

}  // namespace

GlBuffer make_buffer(const GlFunctions& gl) { return generate<GlBuffer>(gl, gl.GenBuffers); }
GlFramebuffer make_framebuffer(const GlFunctions& gl) {
    return generate<GlFramebuffer>(gl, gl.GenFramebuffers);
}
GlRenderbuffer make_renderbuffer(const GlFunctions& gl) {
    return generate<GlRenderbuffer>(gl, gl.GenRenderbuffers);
}
GlTexture make_texture(const GlFunctions& gl) { return generate<GlTexture>(gl, gl.GenTextures); }
GlVertexArray make_vertex_array(const GlFunctions& gl) {
    return generate<GlVertexArray>(gl, gl.GenVertexArrays);
}

void copy_part(const GlFunctions& gl, const GlFramebuffer& from, const DeviceRect& part) {
    if (part.empty()) { return; }
    const GLint right = part.x + part.width;
    const GLint top = part.y + part.height;
    GLint bound = 0;
    gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, from.name());
    gl.BlitFramebuffer(
        part.x, part.y, right, top, part.x, part.y, right, top, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(bound));
}

GlProgram::GlProgram(
    const GlFunctions& gl, std::string_view title, std::string_view vertex, std::string_view fragment)
    : gl_(&gl), program_(gl, gl.CreateProgram()) {
    const GlShader vertex_shader = compile(gl, GL_VERTEX_SHADER, title, vertex);
    const GlShader fragment_shader = compile(gl, GL_FRAGMENT_SHADER, title, fragment);
    gl.AttachShader(program_.name(), vertex_shader.name());
    gl.AttachShader(program_.name(), fragment_shader.name());
    link(gl, program_.name(), title);
}

void GlProgram::set(const char* uniform, int value) const { gl_->Uniform1i(location(uniform), value); }

void GlProgram::set(const char* uniform, float value) const { gl_->Uniform1f(location(uniform), value); }

void GlProgram::set(const char* uniform, float x, float y) const { gl_->Uniform2f(location(uniform), x, y); }

void GlProgram::set(const char* uniform, const Eigen::Vector3d& value) const {
    const Eigen::Vector3f v = value.cast<float>();
    gl_->Uniform3f(location(uniform), v.x(), v.y(), v.z());
}

void GlProgram::set(const char* uniform, const Eigen::Matrix4d& value) const {
    const Eigen::Matrix4f m = value.cast<float>();
    gl_->UniformMatrix4fv(location(uniform), 1, GL_FALSE, m.data());
}

void GlProgram::set(const char* uniform, const Colour& value) const {
    gl_->Uniform4f(location(uniform), value.r, value.g, value.b, value.a);
}

}  // namespace jw::render
