#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "app/host/host.hpp"
#include "render/gl/gl_functions.hpp"

/// The window: GLFW and nothing else.
namespace jw {

struct WindowSetup {
    host::HostSetup host;
    std::optional<std::filesystem::path> file;  ///< nothing: the browser
    std::optional<host::Address> address;       ///< in place of the file, where to begin and what with
    std::string at;
    std::vector<std::string> experiments;  ///< experiments to begin with
    std::string exercise;                  ///< to begin with; empty: none
    std::ostream* log = nullptr;           ///< where faults of drawing are told; must be set
};

/// Shows in `host` what is asked for, but for the exercise.
void show_first(host::Host& host, const WindowSetup& setup);

/// Runs until the window is closed. What was tried and not saved then is in a file that the log names.
/// @throws std::runtime_error with what to do where there is no display or no OpenGL 3.3, or where drawing
///         fails again and again; with the name of that file, if there is one
void run_window(const WindowSetup& setup);

/// Makes a hidden window's context current and calls `use` with it.
/// @throws std::runtime_error as run_window
void with_hidden_window(const std::function<void(const render::GlFunctions& gl)>& use);

/// True if the environment names a display: DISPLAY or WAYLAND_DISPLAY is set.
bool has_display();

}  // namespace jw
