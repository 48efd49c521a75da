#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "app/host/host.hpp"
#include "render/gl/gl_functions.hpp"

/// The window of the program, by GLFW.
namespace jw {

struct WindowSetup {
    host::HostSetup host;
    std::optional<std::filesystem::path> file;  ///< nothing: the browser
    std::optional<host::Address> address;       ///< in place of the file: lesson, place, experiments, tab
    std::string at;
    std::vector<std::string> experiments;  ///< experiments to begin with
    std::string exercise;                  ///< to begin with; empty: none
    std::ostream* log = nullptr;           ///< for errors of drawing and notes; must be set
};

/// Shows in `host` the file or address that `setup` asks for, without the exercise.
void show_first(host::Host& host, const WindowSetup& setup);

/// Runs until the window is closed. Unsaved experiments are then in a file that the log names.
/// @throws std::runtime_error with a remedy if there is no display or no OpenGL 3.3, or if drawing fails
///         again and again; with the name of that file, if there is one
void run_window(const WindowSetup& setup);

/// Makes a hidden window's context current and calls `use` with it.
/// @throws std::runtime_error as run_window
void with_hidden_window(const std::function<void(const render::GlFunctions& gl)>& use);

/// True if the environment names a display: DISPLAY or WAYLAND_DISPLAY is set.
bool has_display();

}  // namespace jw
