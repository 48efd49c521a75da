#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

/// Work in separate processes: a crash, an endless loop or a lack of memory ends one part of the work and
/// nothing else.
namespace jw {

struct WorkerLimits {
    int cpu_seconds = 30;  ///< of the process itself for one part, without its child processes
    std::uint64_t address_bytes = 4ULL << 30U;
};

struct WorkDone {
    std::string result;   ///< what the part returned
    std::string problem;  ///< why it returned nothing
};

/// Pieces of work. One process does the parts of a piece one after the other. If a part ends the process, or
/// takes too long, another process goes on after that part. If the first part of a piece fails, the others
/// are not done.
struct Work {
    int pieces = 0;
    int parts = 1;                                                ///< of each piece
    std::function<std::string(int piece, int part)> carry_out;    ///< its result has at most 4 MB
    std::function<double(int part)> wall_seconds;                 ///< limit for a part
    std::function<void(int piece, std::vector<WorkDone>)> ended;  ///< gets all parts; in the calling process
};

/// Does the work, `jobs` pieces at a time, in processes made by fork. Pieces end in any order. The calling
/// process must have no other thread.
void do_in_processes(const Work& work, int jobs, const WorkerLimits& limits);

}  // namespace jw
