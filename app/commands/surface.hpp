#pragma once

#include <functional>
#include <span>
#include <string>

#include "render/gl_functions.hpp"
#include "render/image.hpp"
#include "render/render_targets.hpp"

/// Tests whether a surface, in memory or in a window, can be drawn on, for `jointwise doctor`.
namespace jw {

struct SurfaceReport {
    enum class State {
        right,        ///< it loads, and the test picture is as it should be
        draws_wrong,  ///< it loads, and the test picture is not, or drawing it ends the program
        missing,      ///< it does not load, and something can be installed or set
        damaged,      ///< it does not load, because a library is there and no library: install it again
        absent,       ///< there is none here, and nothing is wrong with that: no display
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

/// Draws the test picture with the context that is current, looks at it, and fills in the state and what the
/// driver says of itself. Nothing is thrown: a driver that fails draws wrong.
void examine(const render::GlFunctions& gl, SurfaceReport& report);

/// OSMesa.
SurfaceReport examine_offscreen();
/// EGL without a surface; absent where it is not there, which is nothing wrong.
SurfaceReport examine_egl();

/// A shared library that a surface needs, and the Debian package that has it.
struct Library {
    const char* name;
    const char* package;
};

struct LibraryReport {
    SurfaceReport::State state = SurfaceReport::State::right;  ///< or missing, or damaged
    std::string words;  ///< of the system's loader, if it said something
};

/// Loads a library in another process: one that is cut off ends the process that loads it.
LibraryReport examine_library(const char* name);

/// Looks for the first library that is missing or damaged, and fills in state, problem, remedy and packages.
/// @return whether there is one; else `report` stays as it is
bool blame_library(SurfaceReport& report, std::span<const Library> libraries);

/// Draws a window's test picture and reports; empty where the program has no window.
using SurfaceDoctor = std::function<SurfaceReport()>;

/// The test picture: three balls at the corners of a triangle, and one before another in the middle.
inline constexpr int kTestWidth = 160;
inline constexpr int kTestHeight = 120;
/// Draws it with the context that is current, on `targets` of its size.
/// @throws std::runtime_error with the driver's words
render::Image draw_test_picture(const render::GlFunctions& gl, render::RenderTargets& targets);
/// Says what is wrong with a test picture; empty if nothing is.
std::string fault_of(const render::Image& picture);

}  // namespace jw
