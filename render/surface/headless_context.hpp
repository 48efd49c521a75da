#pragma once

#include <memory>
#include <string>

#include "render/gl/gl_functions.hpp"

/// OpenGL without a window: its context and its functions.
namespace jw::render {

/// Contexts for drawing pictures without a window.
enum class HeadlessSurface {
    automatic,  ///< OSMesa, or EGL if OSMesa is missing
    osmesa,     ///< Mesa's own, drawn by the processor; Mesa has not included it since 25.1
    egl,        ///< EGL without a surface; on a machine with a graphics card, the card draws
};

/// Context of OpenGL 3.3 core, or of ES 3.0 on request, without its own framebuffer to draw into.
class HeadlessContext {
public:
    HeadlessContext() = default;
    virtual ~HeadlessContext() = default;
    HeadlessContext(const HeadlessContext&) = delete;
    HeadlessContext& operator=(const HeadlessContext&) = delete;

    /// @throws std::runtime_error if it cannot be made current
    virtual void make_current() = 0;
    const GlFunctions& gl() const { return gl_; }

protected:
    GlFunctions gl_;
};

/// Each @throws std::runtime_error naming the Debian package to install if there is no such context.
std::unique_ptr<HeadlessContext> make_osmesa_context();
std::unique_ptr<HeadlessContext> make_egl_context(GlProfile profile = GlProfile::core_33);
std::unique_ptr<HeadlessContext> make_headless_context(HeadlessSurface surface);

/// The kind that `Offscreen` makes from now on; `automatic` until this is called.
void choose_headless_surface(HeadlessSurface surface);
HeadlessSurface chosen_headless_surface();

/// A shared library that is loaded when the first picture is drawn: for text output, neither the library nor
/// its shader compiler is loaded. If the library is missing or damaged, this can be reported as an error.
class LoadedLibrary {
public:
    /// @param names  tried one after the other
    /// @param error  beginning of the message if none can be loaded
    LoadedLibrary(std::initializer_list<const char*> names, std::string error);

    template <class Function>
    void find(const char* name, Function& function) const {
        function = reinterpret_cast<Function>(address_of(name));
    }

private:
    /// @throws std::runtime_error if there is no such symbol
    void* address_of(const char* name) const;

    std::string error_;
    void* handle_ = nullptr;
};

}  // namespace jw::render
