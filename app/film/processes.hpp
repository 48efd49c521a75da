#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// Processes of this program that share the work of one run.
namespace jw::film {

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
