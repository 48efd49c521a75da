#include "render/gl/gl_objects.hpp"

#include <algorithm>
#include <cmath>
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

std::string log_of(GLuint name, PFNGLGETSHADERINFOLOGPROC read) {
    std::string log(2000, '\0');
    GLsizei written = 0;
    read(name, static_cast<GLsizei>(log.size()), &written, log.data());
    log.resize(static_cast<std::size_t>(written));
    return log;
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
        throw std::runtime_error(
            "the graphics driver rejects shader '" + std::string(title) +
            "': " + log_of(shader.name(), gl.GetShaderInfoLog));
    }
    return shader;
}

void link(const GlFunctions& gl, GLuint program, std::string_view title) {
    gl.LinkProgram(program);
    GLint linked = 0;
    gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked == 0) {
        throw std::runtime_error(
            "the graphics driver cannot link shader '" + std::string(title) +
            "': " + log_of(program, gl.GetProgramInfoLog));
    }
}

}  // namespace

GlRenderbuffer attached_renderbuffer(
    const GlFunctions& gl, GLenum format, GLenum attachment, int samples, int width, int height) {
    auto buffer = GlRenderbuffer::make(gl);
    gl.BindRenderbuffer(GL_RENDERBUFFER, buffer.name());
    gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer.name());
    return buffer;
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

DeviceRect device_rect(const Rect& rect, const FrameSize& frame) {
    const auto pixels = [&](double length) {
        return static_cast<int>(std::lround(length * frame.pixel_ratio));
    };
    return {
        pixels(rect.x), pixels(frame.height - rect.y - rect.height), pixels(rect.width), pixels(rect.height)};
}

DeviceRect device_rect(const Rect& rect, const FrameSize& frame, const FramePart& part) {
    DeviceRect seen = device_rect(rect, frame);
    seen.x -= part.x * frame.pixel_ratio;
    seen.y -= (frame.height - part.y - part.height) * frame.pixel_ratio;
    return seen;
}

DeviceRect device_rect(const FramePart& part, const FrameSize& frame) {
    return {0, 0, part.width * frame.pixel_ratio, part.height * frame.pixel_ratio};
}

DeviceRect shown_rect(const Rect& rect, const FrameSize& frame, const FramePart& part) {
    return common_part(device_rect(rect, frame, part), device_rect(part, frame));
}

DeviceRect common_part(const DeviceRect& a, const DeviceRect& b) {
    const int left = std::max(a.x, b.x);
    const int bottom = std::max(a.y, b.y);
    const int right = std::min(a.x + a.width, b.x + b.width);
    const int top = std::min(a.y + a.height, b.y + b.height);
    return {left, bottom, std::max(right - left, 0), std::max(top - bottom, 0)};
}

}  // namespace jw::render
