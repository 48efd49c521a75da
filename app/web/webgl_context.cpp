#include "app/web/page.hpp"

#include <stdexcept>
#include <string_view>
#include <type_traits>

#include <emscripten/html5_webgl.h>

// declares the functions of WebGL with the types in the table of function pointers
#define JW_DECLARE(type, name) extern "C" std::remove_pointer_t<type> gl##name;
JW_GL_FUNCTIONS(JW_DECLARE)
#undef JW_DECLARE

namespace jw::web {

namespace {

void* function_of(const char* wanted) {
    const std::string_view known(wanted);
#define JW_FIND(type, name) \
    if (known == "gl" #name) { return reinterpret_cast<void*>(&gl##name); }
    JW_GL_FUNCTIONS(JW_FIND)
#undef JW_FIND
    return nullptr;
}

class WebGlContext : public render::HeadlessContext {
public:
    explicit WebGlContext(const char* canvas) {
        EmscriptenWebGLContextAttributes wanted;
        emscripten_webgl_init_context_attributes(&wanted);
        // the picture is drawn into other framebuffers, and copied into that of the canvas
        wanted.alpha = wanted.depth = wanted.stencil = wanted.antialias = false;
        wanted.majorVersion = 2;
        handle_ = emscripten_webgl_create_context(canvas, &wanted);
        if (handle_ <= 0) { throw std::runtime_error("this browser shows no WebGL 2"); }
        WebGlContext::make_current();
        gl_ = render::load_gl_functions(function_of);
    }
    ~WebGlContext() override { emscripten_webgl_destroy_context(handle_); }

    void make_current() override { emscripten_webgl_make_context_current(handle_); }

private:
    EMSCRIPTEN_WEBGL_CONTEXT_HANDLE handle_ = 0;
};

}  // namespace

std::unique_ptr<render::HeadlessContext> make_webgl_context(const char* canvas) {
    return std::make_unique<WebGlContext>(canvas);
}

}  // namespace jw::web
