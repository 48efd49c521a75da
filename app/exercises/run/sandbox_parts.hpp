#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/exercises/run/handles.hpp"
#include "app/exercises/run/sandbox.hpp"

/// Parts of a sandbox: its first process, what its processes use, and the system calls that they may make.
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

/// A filter of system calls for bwrap, as the bytes of a BPF program; empty on processors for which it is not
/// written.
///
/// A student's program needs files, memory and processes. The filter refuses calls that reach more of the
/// kernel (bpf, io_uring, keys, mounts, other processes), calls that take memory that no limit counts (memfd,
/// System V shared memory), and every socket except those between the program's own processes: some kinds of
/// sockets do not belong to a network namespace (AF_VSOCK reaches the host of a virtual machine).
std::string system_call_filter();

}  // namespace jw::exercises
