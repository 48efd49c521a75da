#pragma once

#include <string>
#include <vector>

#include "app/exercises/run/sandbox.hpp"

namespace jw::exercises {

/// Starts `arguments` with exactly the descriptors `fds` (numbered 0, 1, 2 ...), an empty environment,
/// default signals and the limits of one process; if this process is root, as a separate user. The child dies
/// with the thread that calls this. Returns its process id, or -1 with errno. Later errors are written to the
/// child's standard error.
int start_child(
    const std::vector<std::string>& arguments, const std::vector<int>& fds, const SandboxLimits& limits);

}  // namespace jw::exercises
