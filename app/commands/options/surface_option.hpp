#pragma once

#include <string>

namespace CLI {
class App;
}

/// `--surface NAME`, which every command takes: what draws pictures without a window.
namespace jw {

/// Adds the option to the program; commands that are added later take it, too.
void add_surface_option(CLI::App& app, std::string& name);

/// Sets the surface: from the option, else from JOINTWISE_SURFACE, else OSMesa, or EGL if there is no OSMesa.
/// @throws CommandError (bad_input) that names the available ones
void choose_surface(const std::string& name);

}  // namespace jw
