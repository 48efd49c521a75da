#pragma once

#include <cstdint>
#include <functional>
#include <string>

/// Work in processes of their own: a crash, an endless loop or a lack of memory ends one of them and nothing
/// else.
namespace jw {

struct WorkerLimits {
    double wall_seconds = 120.0;
    int cpu_seconds = 60;  ///< of the process itself, without its children
    std::uint64_t address_bytes = 4ULL << 30U;
};

struct WorkDone {
    std::string result;   ///< what the work returned
    std::string problem;  ///< why it returned nothing
};

/// Does `count` pieces of work, `jobs` at a time, each in a process of its own made by fork; `done` is called
/// here, in the order in which they end. The calling process must have no other thread.
/// @param work  its result has at most 4 MB
void do_in_processes(
    int count, int jobs, const WorkerLimits& limits, const std::function<std::string(int)>& work,
    const std::function<void(int, WorkDone)>& done);

}  // namespace jw
