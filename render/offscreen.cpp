#include "render/offscreen.hpp"

#include <array>
#include <cstdint>
#include <stdexcept>

#include "render/address_space.hpp"
#include "render/mesa_settings.hpp"
#include "render/render_targets.hpp"

#include <GL/osmesa.h>
#include <dlfcn.h>

namespace jw::render {

namespace {

// library of Debian 12, and the name that comes with the headers
constexpr std::array kLibraries{"libOSMesa.so.8", "libOSMesa.so"};

/// OSMesa, loaded when the first picture is drawn: text needs none of it, and brings no compiler of shaders
/// into memory. A library that is missing or damaged so is an error that can be told.
struct OsMesa {
    decltype(&OSMesaCreateContextAttribs) create = nullptr;
    decltype(&OSMesaDestroyContext) destroy = nullptr;
    decltype(&OSMesaMakeCurrent) make_current = nullptr;
    decltype(&OSMesaGetProcAddress) get_function = nullptr;

    /// @throws std::runtime_error with the words of the system's loader, or of `settle_mesa`
    static const OsMesa& get() {
        static const OsMesa library;
        return library;
    }

private:
    OsMesa() {
        settle_mesa();
        void* library = nullptr;
        std::string why;
        for (const char* const name : kLibraries) {
            if (library == nullptr) { library = ::dlopen(name, RTLD_NOW | RTLD_LOCAL); }
            if (const char* const words = ::dlerror(); why.empty() && words != nullptr) { why = words; }
        }
        if (library == nullptr) { fail("it cannot be loaded: " + why); }
        find(library, "OSMesaCreateContextAttribs", create);
        find(library, "OSMesaDestroyContext", destroy);
        find(library, "OSMesaMakeCurrent", make_current);
        find(library, "OSMesaGetProcAddress", get_function);
    }

    [[noreturn]] static void fail(const std::string& why) {
        throw std::runtime_error(
            "no OpenGL 3.3 without a window: this needs OSMesa (Debian package libosmesa6), and " + why);
    }

    template <class Function>
    static void find(void* library, const char* name, Function& function) {
        function = reinterpret_cast<Function>(::dlsym(library, name));
        if (function == nullptr) { fail("the one that is there is too old"); }
    }
};

}  // namespace

/// Owns the context; OSMesa wants a colour buffer of its own, which nothing is drawn into.
struct Offscreen::Context {
    OSMesaContext handle = nullptr;
    std::array<std::uint8_t, 16 * 16 * 4> unused{};
    GlFunctions gl;

    /// @param width, height  of the picture that is drawn, for the room that it needs
    Context(int width, int height) {
        check_address_space(width, height);
        constexpr std::array attributes{
            OSMESA_FORMAT,
            OSMESA_RGBA,
            OSMESA_DEPTH_BITS,
            0,
            OSMESA_PROFILE,
            OSMESA_CORE_PROFILE,
            OSMESA_CONTEXT_MAJOR_VERSION,
            3,
            OSMESA_CONTEXT_MINOR_VERSION,
            3,
            0,
            0};
        handle = OsMesa::get().create(attributes.data(), nullptr);
        if (handle == nullptr) {
            throw std::runtime_error(
                "no OpenGL 3.3 without a window: OSMesa gives no core profile context (Debian package "
                "libosmesa6)");
        }
        make_current();
        gl = load_gl_functions(
            [](const char* name) { return reinterpret_cast<void*>(OsMesa::get().get_function(name)); });
    }
    ~Context() { OsMesa::get().destroy(handle); }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    void make_current() {
        if (OsMesa::get().make_current(handle, unused.data(), GL_UNSIGNED_BYTE, 16, 16) == GL_FALSE) {
            throw std::runtime_error("OSMesa cannot make its context current");
        }
    }
};

Offscreen::Offscreen(int width, int height, int samples)
    : context_(std::make_unique<Context>(width, height)),
      wanted_samples_(samples),
      targets_(std::make_unique<RenderTargets>(context_->gl, width, height, samples)) {}

Offscreen::~Offscreen() {
    // the targets are deleted in their own context, whichever was current
    OsMesa::get().make_current(context_->handle, context_->unused.data(), GL_UNSIGNED_BYTE, 16, 16);
}

const GlFunctions& Offscreen::gl() const { return context_->gl; }

FrameSize Offscreen::size() const { return targets_->size(); }

int Offscreen::samples() const { return targets_->samples(); }

std::string Offscreen::renderer() const {
    make_current();
    return renderer_name(gl());
}

void Offscreen::resize(int width, int height) {
    check_address_space(width, height);
    make_current();
    targets_ = std::make_unique<RenderTargets>(gl(), width, height, wanted_samples_);
}

void Offscreen::make_current() const { context_->make_current(); }

void Offscreen::begin_3d(const Colour& paper, const std::optional<Rect>& drawn) {
    make_current();
    targets_->begin_3d(paper, drawn);
}

void Offscreen::begin_2d() {
    make_current();
    targets_->begin_2d();
}

Image Offscreen::read(bool is_opaque) {
    make_current();
    return targets_->read(is_opaque);
}

}  // namespace jw::render
