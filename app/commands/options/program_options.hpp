#pragma once

#include <string>

namespace CLI {
class App;
}

/// Options that every command takes.
namespace jw {

/// Adds `--language TAG`, the language of the program's own sentences, and `--surface NAME`, the library that
/// draws pictures without a window. Commands that are added later take them, too.
void add_program_options(CLI::App& app, std::string& language, std::string& surface);

/// Sets the language: from the option, else from JOINTWISE_LANGUAGE, else English.
/// @throws CommandError (bad_input) that names the available languages
void choose_language(const std::string& tag);

/// Sets the surface: from the option, else from JOINTWISE_SURFACE, else OSMesa, or EGL if there is no OSMesa.
/// @throws CommandError (bad_input) that names the available ones
void choose_surface(const std::string& name);

}  // namespace jw
