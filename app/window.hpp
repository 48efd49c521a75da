#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/host/host.hpp"
#include "render/gl_functions.hpp"

/// The window: GLFW and nothing else.
namespace jw {

struct WindowSetup {
    host::HostSetup host;
    std::optional<std::filesystem::path> file;  ///< nothing: the browser
    std::string at;
    host::Tab tab = host::Tab::step;
    std::vector<std::string> tries;  ///< experiments to begin with
};

/// Runs until the window is closed.
/// @throws std::runtime_error with what to do where there is no display or no OpenGL 3.3
void run_window(const WindowSetup& setup);

/// Makes a hidden window's context current and calls `use` with it.
/// @throws std::runtime_error as run_window
void with_hidden_window(const std::function<void(const render::GlFunctions& gl)>& use);

/// Whether this machine says that there is a display: DISPLAY or WAYLAND_DISPLAY is set.
bool has_display();

}  // namespace jw
