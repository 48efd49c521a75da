#pragma once

#include <catch2/catch.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <unistd.h>

#include "app/exercises/run/languages.hpp"
#include "app/exercises/run/sandbox.hpp"

namespace jw::exercises::test {

/// True without bubblewrap: no program is run then, which has a test of its own; all others are skipped.
inline bool no_sandbox_here() {
    const SandboxAvailability& here = sandbox_availability();
    if (!here.available) { WARN("not tested: " << here.reason); }
    return !here.available;
}

/// A folder that is removed with its owner.
class Scratch {
public:
    Scratch() {
        std::string name = (std::filesystem::temp_directory_path() / "jw_run_XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) { throw std::runtime_error("no temporary folder"); }
        path_ = name;
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    ~Scratch() { std::filesystem::remove_all(path_); }

    std::string operator/(const std::string& name) const { return (path_ / name).string(); }
    std::string path() const { return path_.string(); }
    /// Writes a file and returns its path.
    std::string file(const std::string& name, const std::string& content) const {
        std::ofstream(path_ / name) << content;
        return *this / name;
    }

private:
    std::filesystem::path path_;
};

/// Limits so small that a test of one does not take long on a busy machine.
inline SandboxLimits short_limits() {
    SandboxLimits limits;
    limits.wall_seconds = 6.0;
    limits.cpu_seconds = 1.0;
    limits.memory_bytes = 128U << 20U;
    return limits;
}

/// Runs a Python program in the sandbox, from any thread: it reports nothing to Catch2, which is not
/// made for that.
inline SandboxResult silent_python(
    const std::string& source, const std::string& input = {}, const SandboxLimits& limits = short_limits()) {
    SandboxJob job;
    job.command = {"/usr/bin/python3", "-I", std::string(kSandboxFolder) + "/task.py"};
    job.files = {{"task.py", source, false}};
    job.input = input;
    job.limits = limits;
    return run_in_sandbox(job);
}

/// Runs a Python program in the sandbox; prints its result where a check fails. Only for the own
/// thread of the test.
inline SandboxResult python(
    const std::string& source, const std::string& input = {}, const SandboxLimits& limits = short_limits()) {
    SandboxResult result = silent_python(source, input, limits);
    UNSCOPED_INFO("could not run: " << result.could_not_run);
    UNSCOPED_INFO(
        "status " << result.exit_status << " after " << result.wall_seconds << " s, " << result.cpu_seconds
                  << " s of computing");
    UNSCOPED_INFO("standard error: " << result.err.substr(0, 1000));
    return result;
}

/// Number of processes of this machine that have a word in their command line.
inline int processes_with(const std::string& word) {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
        std::ifstream in(entry.path() / "cmdline");
        // a process that ends meanwhile cannot be read: the stream ignores that, an iterator would throw
        std::ostringstream line;
        line << in.rdbuf();
        if (line.str().find(word) != std::string::npos) { ++count; }
    }
    return count;
}

}  // namespace jw::exercises::test
