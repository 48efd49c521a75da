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

}  // namespace jw::render
