#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "app/commands/program/commands.hpp"

namespace jw {

/// Adds a command to the command line, like those of commands.hpp.
using AddCommand = std::function<void(const CommandLine& line)>;

/// Runs a program with these commands, in the order in which its help lists them; without a command, it runs
/// `open`.
/// @param arguments without the program's name
/// @return the exit status
int run_commands(
    std::span<const AddCommand> commands, const std::vector<std::string>& arguments, const Streams& streams);

/// Runs a program in this process. @return its exit status, or bad_input if its output could not be written
/// @param run  the program, given its arguments and streams
int run_process(
    int argc, char** argv,
    const std::function<int(const std::vector<std::string>& arguments, const Streams& streams)>& run);

}  // namespace jw
