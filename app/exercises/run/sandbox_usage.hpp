#pragma once

#include <cstdint>
#include <vector>

#include "app/exercises/run/handles.hpp"

namespace jw::exercises {

/// Resources that all processes of a sandbox use together at one moment.
struct SandboxUsage {
    double cpu_seconds = 0.0;        ///< of living processes and of the ended ones that they have waited for
    std::uint64_t memory_bytes = 0;  ///< shared pages are counted for each process
    std::uint64_t files = 0;         ///< in /tmp and /dev/shm
};

/// Inspects a sandbox from outside: its own /proc lists its processes and no others.
class UsageMeter {
public:
    /// Opens a sandbox; false if it cannot be inspected. `first_process`: its number on this machine.
    bool open(int first_process);
    bool is_open() const { return static_cast<bool>(processes_); }
    SandboxUsage measure() const;

private:
    Handle processes_;
    Handle tmp_;
    Handle shared_memory_;
};

/// Numbers of the processes that a process has started and that nobody has waited for.
std::vector<int> children_of(int process);

}  // namespace jw::exercises
