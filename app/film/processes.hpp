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

/// Its value, where another process has started this one; not read yet.
std::optional<std::string> part_of_environment();

struct Part {
    int part = 0;  ///< from 0
    int parts = 1;
};

/// "2/4" is the second of four. @return false for anything else
bool read_part(const std::string& text, Part& part);

/// Runs a command line once for each of `parts`, all at once, and waits for them. What they print goes into
/// files `part-1.log` and so on in `folder`. If one fails, the others are stopped.
/// @param waiting  called a few times a second until they have ended
/// @throws std::runtime_error with the last line of what a part has printed, if it failed
void run_parts(
    const std::vector<std::string>& command_line, int parts, const std::filesystem::path& folder,
    const std::function<void()>& waiting);

/// In a process that draws a part: ends it with the one that has started it.
void end_with_parent();

}  // namespace jw::film
