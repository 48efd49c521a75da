#pragma once

#include <cstddef>
#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

namespace jw::exercises {

/// Folder of the sandbox that has the files of a run.
inline constexpr const char* kSandboxFolder = "/submission";
inline constexpr const char* kBwrap = "/usr/bin/bwrap";

/// Longest time that setting up a sandbox may take on a busy machine [s].
inline constexpr double kLongestSetUp = 20.0;

/// Limits of a program in a sandbox. Times are in seconds: of the clock, or of all processors together.
struct SandboxLimits {
    double wall_seconds = 20.0;
    double cpu_seconds = 5.0;                    ///< of all processes of the run together
    std::uint64_t memory_bytes = 512ULL << 20U;  ///< of one process, and of all of them together
    std::uint64_t address_bytes = 4ULL << 30U;   ///< of one process: reserved, used or not
    int processes = 32;                          ///< processes and threads
    std::uint64_t file_bytes = 32ULL << 20U;     ///< of one file
    std::uint64_t tmp_bytes = 64ULL << 20U;      ///< of all files of /tmp together
    std::uint64_t tmp_files = 5000;  ///< files and folders of /tmp, which cost memory even if empty
    int open_files = 64;
    std::size_t out_bytes = 1U << 20U;   ///< of standard output; a program that writes more is stopped
    std::size_t err_bytes = 64U << 10U;  ///< of standard error, likewise
};

/// A file that the sandbox shows in kSandboxFolder, read-only.
struct SandboxFile {
    std::string name;  ///< without a folder
    std::string content;
    bool executable = false;
};

struct SandboxJob {
    std::vector<std::string> command;  ///< the program by its full path, and its arguments
    std::vector<SandboxFile> files;
    std::string input;  ///< standard input, which ends where this text ends
    SandboxLimits limits;
    std::string bwrap = kBwrap;  ///< tests use another one
    std::stop_token stop;        ///< kills the command if nobody wants the result any more
};

struct SandboxResult {
    /// Reason why the program was not started; empty if it was. If it is not empty, the other members have
    /// no meaning.
    std::string could_not_run;
    int exit_status = 0;  ///< 128 + signal if a signal ended it
    int signal = 0;       ///< that ended it, 0 if none; an exit status above 128 is taken as a signal
    std::string out;      ///< bytes as written: need not be text (safe_text.hpp)
    std::string err;
    bool timed_out = false;        ///< by the clock or by the processor
    bool too_much_output = false;  ///< on standard output or error
    bool too_many_files = false;
    bool out_of_memory = false;  ///< stopped for this reason, or its error output names it
    double wall_seconds = 0.0;   ///< without the time to set up the sandbox
    double cpu_seconds = 0.0;    ///< of all processes, with a few milliseconds of the sandbox itself

    /// True if the program ran, ended by itself and reports success.
    bool succeeded() const;
};

/// Runs a command without network, without the files of this machine except /usr (read-only, without
/// /usr/local), with an empty environment, and with limits on everything that it may use. When this returns,
/// none of its processes is left. Needs bubblewrap and user namespaces; without them, the command is not run.
/// If this process is root, the command runs as a user that does not exist. May be called by several threads
/// and processes at once.
SandboxResult run_in_sandbox(const SandboxJob& job);

struct SandboxAvailability {
    bool available = false;
    std::string reason;  ///< why not, as one sentence
};

/// Availability of a sandbox here: tried once per process, with a command that does nothing.
const SandboxAvailability& sandbox_availability();

/// Availability of a sandbox by another bubblewrap, tried again at each call.
SandboxAvailability try_sandbox(const std::string& bwrap);

}  // namespace jw::exercises
