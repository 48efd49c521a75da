#include "render/gl/gl_errors.hpp"

#include <stdexcept>

namespace jw::render {
namespace {

// one error of each kind may wait, on several servers; a lost context reports errors without end
constexpr int kMostWaiting = 32;

const char* words_for(GLenum error) {
    switch (error) {
        case GL_INVALID_ENUM: return "invalid name";
        case GL_INVALID_VALUE: return "invalid value";
        case GL_INVALID_OPERATION: return "invalid operation";
        case GL_INVALID_FRAMEBUFFER_OPERATION: return "invalid framebuffer";
        case GL_OUT_OF_MEMORY: return "out of memory";
        case GL_CONTEXT_LOST: return "the graphics card was reset";
        default: return "unknown";
    }
}

std::string text_of(GLenum error) {
    constexpr const char* digits = "0123456789abcdef";
    std::string code;
    for (GLenum rest = error; rest != 0; rest >>= 4U) { code.insert(code.begin(), digits[rest & 15U]); }
    return "OpenGL error 0x" + code + " (" + words_for(error) + ")";
}

}  // namespace

std::string take_gl_errors(const GlFunctions& gl) {
    const GLenum first = gl.GetError();
    if (first == GL_NO_ERROR) { return {}; }
    for (int k = 1; k < kMostWaiting && gl.GetError() != GL_NO_ERROR; ++k) {}
    return text_of(first);
}

void throw_on_gl_error(const GlFunctions& gl, const char* during) {
    if (const std::string error = take_gl_errors(gl); !error.empty()) {
        throw std::runtime_error(std::string(during) + " failed with " + error);
    }
}

}  // namespace jw::render
