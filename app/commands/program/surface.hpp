#pragma once

#include <functional>
#include <span>
#include <string>

#include "render/files/image.hpp"
#include "render/gl/gl_functions.hpp"
#include "render/gl/render_targets.hpp"

/// Tests whether a surface, in memory or in a window, can be drawn on, for `jointwise doctor`.
namespace jw {

struct SurfaceReport {
    enum class State {
        right,        ///< it loads, and the test picture is right
        draws_wrong,  ///< it loads, but the test picture is wrong, or drawing it ends the program
        missing,      ///< it does not load, and something can be installed or set
        damaged,      ///< it does not load, because the file is not a valid library: install it again
        absent,       ///< there is none here, and that is not an error: no display
    };
    std::string name;  ///< "offscreen", "window", "egl"
    State state = State::absent;
    std::string problem;   ///< what is wrong or absent
    std::string remedy;    ///< what to do about it, may be empty
    std::string packages;  ///< Debian packages to install, may be empty
    std::string renderer;
    std::string gl_version;
    int samples = 0;
};

/// Draws the test picture with the current context, examines it, and fills in the state and the driver's
/// names. Nothing is thrown: if a driver fails, the state is draws_wrong.
void examine(const render::GlFunctions& gl, SurfaceReport& report);

/// OSMesa.
SurfaceReport examine_offscreen();
/// EGL without a surface; absent if it is not installed, which is not an error.
SurfaceReport examine_egl();

/// A shared library that a surface needs, and the Debian package that has it.
struct Library {
    const char* name;
    const char* package;
};

struct LibraryReport {
    SurfaceReport::State state = SurfaceReport::State::right;  ///< or missing, or damaged
    std::string words;                                         ///< message of the system's loader, if any
};

/// Loads a library in another process, since a truncated one ends the process that loads it.
LibraryReport examine_library(const char* name);

/// Finds the first library that is missing or damaged, and fills in state, problem, remedy and packages.
/// @return true if there is one; otherwise `report` stays as it is
bool blame_library(SurfaceReport& report, std::span<const Library> libraries);

/// Draws the test picture in a window and reports; empty if the program has no window.
using SurfaceDoctor = std::function<SurfaceReport()>;

/// The test picture: three balls at the corners of a triangle, and one in front of another in the middle.
inline constexpr int kTestWidth = 160;
inline constexpr int kTestHeight = 120;
/// Draws it with the current context, on `targets` of its size.
/// @throws std::runtime_error with the driver's message
render::Image draw_test_picture(const render::GlFunctions& gl, render::RenderTargets& targets);
/// Says what is wrong with a test picture; empty if nothing is.
std::string fault_of(const render::Image& picture);

}  // namespace jw
