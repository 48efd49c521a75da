#include <array>
#include <stdexcept>

#include "render/surface/headless_context.hpp"
#include "render/surface/mesa_settings.hpp"

// avoids the headers of a window system
#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace jw::render {

namespace {

constexpr const char* kNeeds =
    "no OpenGL 3.3 without a window: this needs EGL (Debian packages libegl1 and libegl-mesa0), and ";

/// EGL and its only display without a window system; it exists until the program ends.
struct Egl {
    decltype(&eglGetPlatformDisplay) get_display = nullptr;
    decltype(&eglInitialize) initialize = nullptr;
    decltype(&eglBindAPI) bind_api = nullptr;
    decltype(&eglCreateContext) create = nullptr;
    decltype(&eglDestroyContext) destroy = nullptr;
    decltype(&eglMakeCurrent) make_current = nullptr;
    decltype(&eglGetProcAddress) get_function = nullptr;
    EGLDisplay display = EGL_NO_DISPLAY;

    /// @throws std::runtime_error with the message of the system's loader, or of `settle_mesa`
    static const Egl& get() {
        static const Egl library;
        return library;
    }

private:
    Egl() {
        settle_mesa();
        const LoadedLibrary library({"libEGL.so.1", "libEGL.so"}, kNeeds);
        library.find("eglGetPlatformDisplay", get_display);
        library.find("eglInitialize", initialize);
        library.find("eglBindAPI", bind_api);
        library.find("eglCreateContext", create);
        library.find("eglDestroyContext", destroy);
        library.find("eglMakeCurrent", make_current);
        library.find("eglGetProcAddress", get_function);
        // without a surface, no configuration needs to be chosen
        display = get_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
        if (display == EGL_NO_DISPLAY || initialize(display, nullptr, nullptr) == EGL_FALSE) {
            throw std::runtime_error(
                std::string(kNeeds) + "the one that is there knows no surfaceless display");
        }
    }
};

/// Arguments with which EGL is asked for a profile.
struct Kind {
    const char* name;
    EGLenum api;
    std::array<EGLint, 7> attributes;
};

Kind kind_of(GlProfile profile) {
    if (profile == GlProfile::es_30) {
        return {
            "OpenGL ES 3.0",
            EGL_OPENGL_ES_API,
            {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE, EGL_NONE, EGL_NONE}};
    }
    return {
        "core profile",
        EGL_OPENGL_API,
        {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
         EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE}};
}

class EglContext : public HeadlessContext {
public:
    explicit EglContext(GlProfile profile) : api_(kind_of(profile).api) {
        const Kind kind = kind_of(profile);
        const Egl& egl = Egl::get();
        if (egl.bind_api(api_) == EGL_TRUE) {
            handle_ = egl.create(egl.display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kind.attributes.data());
        }
        if (handle_ == EGL_NO_CONTEXT) {
            throw std::runtime_error(
                std::string(kNeeds) + "the one that is there gives no " + kind.name + " context");
        }
        EglContext::make_current();
        gl_ = load_gl_functions(
            [](const char* name) { return reinterpret_cast<void*>(Egl::get().get_function(name)); });
    }
    ~EglContext() override {
        const Egl& egl = Egl::get();
        egl.make_current(egl.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        egl.destroy(egl.display, handle_);
    }

    void make_current() override {
        const Egl& egl = Egl::get();
        // EGL binds the interface for each thread separately
        egl.bind_api(api_);
        if (egl.make_current(egl.display, EGL_NO_SURFACE, EGL_NO_SURFACE, handle_) == EGL_FALSE) {
            throw std::runtime_error("EGL cannot make its context current");
        }
    }

private:
    EGLenum api_;
    EGLContext handle_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<HeadlessContext> make_egl_context(GlProfile profile) {
    return std::make_unique<EglContext>(profile);
}

}  // namespace jw::render
