#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

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

}  // namespace jw::film
