#pragma once

#include <string>
#include <vector>

#include "app/exercises/run/sandbox.hpp"

namespace jw::exercises {

/// Numbers of the descriptors that bwrap is started with, after 0, 1 and 2.
inline constexpr int kStartedFd = 3;    ///< a byte is written here when the program is about to start
inline constexpr int kInfoFd = 4;       ///< bwrap writes here which process is the first of the sandbox
inline constexpr int kFilterFd = 5;     ///< the filter of system calls
inline constexpr int kFirstFileFd = 6;  ///< the contents of the files of a job, one after the other

/// The arguments of bwrap for a job, with its own path first.
std::vector<std::string> bwrap_arguments(const SandboxJob& job);

}  // namespace jw::exercises
