#pragma once

#include <string>

#include <CLI/CLI.hpp>

/// `--language TAG`, the language of the program's own sentences, which every command takes.
namespace jw {

/// Adds the option to the program; commands that are added afterwards take it, too.
void add_language_option(CLI::App& app, std::string& tag);

/// Sets the language: that of the option, else of JOINTWISE_LANGUAGE, else English.
/// @throws CommandError (bad_input) that names the languages there are
void choose_language(const std::string& tag);

}  // namespace jw
