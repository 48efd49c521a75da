#pragma once

#include <CLI/CLI.hpp>

#include <memory>
#include <string>

#include "app/commands/program/commands.hpp"

namespace jw {

/// Adds an option with a value, or an argument. @param type  what the help shows for the value
template <class Value>
CLI::Option* add_value(
    CLI::App& command, const std::string& name, Value& value, const std::string& type,
    const std::string& help) {
    return command.add_option(name, value, help)->type_name(type);
}

/// A command without its options yet, and where these are kept until it runs.
template <class Options>
struct NewCommand {
    CLI::App& command;
    Options& options;
};

/// Adds a command that carries out `what` with its options.
/// @param footer  an example; empty: that of the program or command that it belongs to
template <class Options>
NewCommand<Options> add_command(
    const CommandLine& line, const std::string& name, const std::string& about,
    Exit (*what)(const Options&, const Streams&), const std::string& footer = {}) {
    CLI::App* const command = line.app.add_subcommand(name, about);
    if (!footer.empty()) { command->footer(footer); }
    const auto options = std::make_shared<Options>();
    command->callback([options, what, &run = line.run, &streams = line.streams] {
        run = [options, what, &streams] { return what(*options, streams); };
    });
    return {*command, *options};
}

}  // namespace jw
