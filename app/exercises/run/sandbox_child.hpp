#pragma once

#include <string>
#include <vector>

#include "app/exercises/run/sandbox.hpp"

namespace jw::exercises {

/// Starts `arguments` with exactly the descriptors `fds` (numbered 0, 1, 2 ...), an empty environment,
/// default signals, the limits of one process, and, where we are root, as a user of its own. It dies with the
/// thread that calls this. Returns its process id, or -1 with errno. What goes wrong after that is written to
/// its standard error.
int start_child(
    const std::vector<std::string>& arguments, const std::vector<int>& fds, const SandboxLimits& limits);

}  // namespace jw::exercises
