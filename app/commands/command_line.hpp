#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "app/commands/commands.hpp"

namespace jw {

/// Adds a command to the command line, as those of commands.hpp do.
using AddCommand = std::function<void(CLI::App& app, const Streams& streams, Run& run)>;

/// A program that has these commands, in the order in which its help lists them; `open` is what is run
/// without any.
/// @param arguments without the program's name
/// @return the exit status
int run_commands(
    std::span<const AddCommand> commands, const std::vector<std::string>& arguments, const Streams& streams);

/// The process around a program: its streams, and its status where they cannot be written.
/// @param run  the program, given its arguments and streams
int run_process(
    int argc, char** argv,
    const std::function<int(const std::vector<std::string>& arguments, const Streams& streams)>& run);

}  // namespace jw
