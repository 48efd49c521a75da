#include "render/gl/gl_functions.hpp"

#include <stdexcept>
#include <string>
#include <string_view>

namespace jw::render {

namespace {

template <class Function>
void load(Function& function, const char* name, GlLoader loader, std::string& missing) {
    // object to function pointer: every GL loader does this; conditionally supported, and fine on POSIX
    function = reinterpret_cast<Function>(loader(name));
    if (function == nullptr) {
        missing += missing.empty() ? "" : ", ";
        missing += name;
    }
}

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

GlFunctions load_gl_functions(GlLoader loader) {
    GlFunctions gl;
    std::string missing;
    const auto check = [&missing] {
        if (missing.empty()) { return; }
        throw std::runtime_error("the graphics driver lacks parts of OpenGL 3.3: " + missing);
    };
#define JW_LOAD(type, name) load(gl.name, "gl" #name, loader, missing);
    JW_GL_FUNCTIONS(JW_LOAD)
    check();
    const auto* const version = reinterpret_cast<const char*>(gl.GetString(GL_VERSION));
    if (version != nullptr && std::string_view(version).starts_with("OpenGL ES")) {
        gl.profile = GlProfile::es_30;
        return gl;
    }
    JW_GL_33_FUNCTIONS(JW_LOAD)
#undef JW_LOAD
    check();
    return gl;
}

std::string renderer_name(const GlFunctions& gl) {
    const auto text = [&gl](GLenum name) {
        const auto* const found = reinterpret_cast<const char*>(gl.GetString(name));
        return std::string(found == nullptr ? "unknown" : found);
    };
    return text(GL_RENDERER) + ", " + text(GL_VERSION);
}

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
