#pragma once

#include <string>

#include <CLI/CLI.hpp>

/// `--language TAG`, which every command takes: the language of the program's own sentences.
namespace jw {

/// Adds the option to the program; commands that are added later take it, too.
void add_language_option(CLI::App& app, std::string& tag);

/// Sets the language: from the option, else from JOINTWISE_LANGUAGE, else English.
/// @throws CommandError (bad_input) that names the available languages
void choose_language(const std::string& tag);

}  // namespace jw
