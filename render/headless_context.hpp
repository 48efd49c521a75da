#pragma once

#include <memory>
#include <string>

#include "render/gl_functions.hpp"

/// OpenGL without a window: whose it is, and its functions.
namespace jw::render {

/// Contexts that pictures can be drawn in without a window.
enum class HeadlessSurface {
    automatic,  ///< OSMesa, and where there is none EGL
    osmesa,     ///< Mesa's own, drawn by the processor; Mesa has left it out since 25.1
    egl,        ///< EGL without a surface; on a machine with a graphics card that draws
};

/// Context of OpenGL 3.3 core, or ES 3.0 where that is asked for, without a framebuffer of its own that
/// anything is drawn into.
class HeadlessContext {
public:
    HeadlessContext() = default;
    virtual ~HeadlessContext() = default;
    HeadlessContext(const HeadlessContext&) = delete;
    HeadlessContext& operator=(const HeadlessContext&) = delete;

    /// @throws std::runtime_error if that is not possible
    virtual void make_current() = 0;
    const GlFunctions& gl() const { return gl_; }

protected:
    GlFunctions gl_;
};

/// Each @throws std::runtime_error with the Debian package that has it, if there is none.
std::unique_ptr<HeadlessContext> make_osmesa_context();
std::unique_ptr<HeadlessContext> make_egl_context(GlProfile profile = GlProfile::core_33);
std::unique_ptr<HeadlessContext> make_headless_context(HeadlessSurface surface);

/// The kind that `Offscreen` makes from now on; `automatic` until this is called.
void choose_headless_surface(HeadlessSurface surface);
HeadlessSurface chosen_headless_surface();

/// A shared library that is loaded when the first picture is drawn: text needs none of it, and brings no
/// compiler of shaders into memory. One that is missing or damaged so is an error that can be told.
class LoadedLibrary {
public:
    /// @param names  tried one after the other
    /// @param error  that begins what is told if none can be loaded
    LoadedLibrary(std::initializer_list<const char*> names, std::string error);

    template <class Function>
    void find(const char* name, Function& function) const {
        function = reinterpret_cast<Function>(address_of(name));
    }

private:
    /// @throws std::runtime_error if it is not there
    void* address_of(const char* name) const;

    std::string error_;
    void* handle_ = nullptr;
};

}  // namespace jw::render
