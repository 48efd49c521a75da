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

/// Starts `arguments` with exactly the descriptors `fds` (numbered 0, 1, 2 ...), an empty environment,
/// default signals and the limits of one process; if this process is root, as a separate user. The child dies
/// with the thread that calls this. Returns its process id, or -1 with errno. Later errors are written to the
/// child's standard error.
int start_child(
    const std::vector<std::string>& arguments, const std::vector<int>& fds, const SandboxLimits& limits);

}  // namespace jw::exercises
