#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace jw::film {

/// Another program that is to be started.
struct Command {
    std::vector<std::string> words;        ///< the first is the program, looked for on the path
    std::vector<std::string> environment;  ///< "NAME=value"; empty: that of this process
    std::filesystem::path log;             ///< file for all that it prints
};

/// Starts it, and does not wait. @throws std::runtime_error if that is not possible
pid_t start(const Command& command);

/// The last line in a file that is not empty; empty if there is none.
std::string last_line_of(const std::filesystem::path& file);

}  // namespace jw::film
