#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// Programs that are started, and processes of this program that share the work of one run.
namespace jw::film {

/// A program to start.
struct Command {
    std::vector<std::string> words;        ///< the first is the program, which is searched for on the path
    std::vector<std::string> environment;  ///< "NAME=value"; empty: that of this process
    std::filesystem::path log;             ///< file for everything that it prints
};

/// Starts a program, and does not wait. @throws std::runtime_error if it cannot be started
pid_t start(const Command& command);

/// The last non-empty line of a file; empty if there is none.
std::string last_line_of(const std::filesystem::path& file);

/// Variable of the environment that tells a process which part of the pictures it draws.
inline constexpr const char* kPartVariable = "JOINTWISE_PART";

/// Value of the variable, if another process has started this one; not parsed.
std::optional<std::string> part_of_environment();

struct Part {
    int part = 0;  ///< from 0
    int parts = 1;
};

/// Reads "2/4": the second of four parts. @return false for anything else
bool read_part(const std::string& text, Part& part);

/// Runs a command line once for each of `parts`, all at the same time, and waits for them. Their output goes
/// into files `part-1.log` and so on in `folder`. If one fails, the others are stopped.
/// @param waiting  called many times a second until they have ended
/// @throws std::runtime_error with the last line of the output of a part that has failed
void run_parts(
    const std::vector<std::string>& command_line, int parts, const std::filesystem::path& folder,
    const std::function<void()>& waiting);

/// For a process that draws a part: it ends when the process that has started it ends.
void end_with_parent();

}  // namespace jw::film
