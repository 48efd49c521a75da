#include <array>
#include <cstdint>
#include <stdexcept>

#include "render/surface/headless_context.hpp"
#include "render/surface/mesa_settings.hpp"

#include <GL/osmesa.h>

namespace jw::render {

namespace {

struct OsMesa {
    decltype(&OSMesaCreateContextAttribs) create = nullptr;
    decltype(&OSMesaDestroyContext) destroy = nullptr;
    decltype(&OSMesaMakeCurrent) make_current = nullptr;
    decltype(&OSMesaGetProcAddress) get_function = nullptr;

    /// @throws std::runtime_error with the message of the system's loader, or of `settle_mesa`
    static const OsMesa& get() {
        static const OsMesa library;
        return library;
    }

private:
    OsMesa() {
        settle_mesa();
        // library of Debian 12, and the name that comes with the headers
        const LoadedLibrary library(
            {"libOSMesa.so.8", "libOSMesa.so"},
            "no OpenGL 3.3 without a window: this needs OSMesa (Debian package libosmesa6), and ");
        library.find("OSMesaCreateContextAttribs", create);
        library.find("OSMesaDestroyContext", destroy);
        library.find("OSMesaMakeCurrent", make_current);
        library.find("OSMesaGetProcAddress", get_function);
    }
};

/// Context of OSMesa, which requires its own colour buffer; nothing is drawn into that buffer.
class OsMesaContext : public HeadlessContext {
public:
    OsMesaContext() {
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
        handle_ = OsMesa::get().create(attributes.data(), nullptr);
        if (handle_ == nullptr) {
            throw std::runtime_error(
                "no OpenGL 3.3 without a window: OSMesa gives no core profile context (Debian package "
                "libosmesa6)");
        }
        OsMesaContext::make_current();
        gl_ = load_gl_functions(
            [](const char* name) { return reinterpret_cast<void*>(OsMesa::get().get_function(name)); });
    }
    ~OsMesaContext() override { OsMesa::get().destroy(handle_); }

    void make_current() override {
        if (OsMesa::get().make_current(handle_, unused_.data(), GL_UNSIGNED_BYTE, 16, 16) == GL_FALSE) {
            throw std::runtime_error("OSMesa cannot make its context current");
        }
    }

private:
    OSMesaContext handle_ = nullptr;
    std::array<std::uint8_t, 16 * 16 * 4> unused_{};
};

}  // namespace

std::unique_ptr<HeadlessContext> make_osmesa_context() { return std::make_unique<OsMesaContext>(); }

}  // namespace jw::render
