#pragma once

#include <string>

namespace CLI {
class App;
}

/// `--surface NAME`, what pictures without a window are drawn with, which every command takes.
namespace jw {

/// Adds the option to the program; commands that are added afterwards take it, too.
void add_surface_option(CLI::App& app, std::string& name);

/// Sets it: that of the option, else of JOINTWISE_SURFACE, else OSMesa and where there is none EGL.
/// @throws CommandError (bad_input) that names those there are
void choose_surface(const std::string& name);

}  // namespace jw
