#include <cstdio>
#include <cstring>

#include "app/exercises/run/safe_text.hpp"
#include "app/exercises/run/sandbox.hpp"

namespace jw::exercises {
namespace {

std::string megabytes(std::uint64_t bytes) {
    constexpr std::uint64_t kilo = 1U << 10U;
    return bytes < kilo * kilo ? std::to_string(bytes / kilo) + " kB"
                               : std::to_string(bytes / kilo / kilo) + " MB";
}

/// A limit in seconds, of which fractions matter in tests only.
std::string in_seconds(double seconds) {
    char text[32];
    std::snprintf(text, sizeof text, "%g s", seconds);
    return text;
}

/// Error message of the program about its end: the last line that calls itself an error ("NameError: ...",
/// "error: ..."), since Octave and JavaScript write where it happened behind it, or else the last line.
std::string last_words(const std::string& err) {
    std::string text = printable(err);
    while (text.ends_with('\n') || text.ends_with(' ')) { text.pop_back(); }
    constexpr std::string_view kOctavesPlace = "\nerror: called from";
    text = text.substr(0, text.find(kOctavesPlace));
    const std::size_t line = text.rfind('\n', text.rfind("rror: "));
    const std::string last = line == std::string::npos ? text : text.substr(line + 1);
    return last.empty() ? last : ": " + first_lines(last.substr(0, last.find('\n')), 1, 200);
}

}  // namespace

std::string fault_of(const SandboxResult& result, const SandboxLimits& limits) {
    if (!result.could_not_run.empty()) { return "was not run: " + result.could_not_run; }
    if (result.too_much_output) {
        return "was stopped: it wrote more than " + megabytes(limits.out_bytes) + " to standard output, or " +
               megabytes(limits.err_bytes) + " to standard error";
    }
    if (result.out_of_memory) {
        return "needs more memory than the " + megabytes(limits.memory_bytes) + " allowed";
    }
    if (result.too_many_files) {
        return "was stopped: it made more than " + std::to_string(limits.tmp_files) + " files";
    }
    if (result.timed_out) {
        return "was stopped: it takes longer than " + in_seconds(limits.cpu_seconds) + " of computing or " +
               in_seconds(limits.wall_seconds) + " in all";
    }
    if (result.signal != 0) {
        return std::string("was ended by a signal (") + ::strsignal(result.signal) + ")" +
               last_words(result.err);
    }
    if (result.exit_status != 0) {
        return "ended with status " + std::to_string(result.exit_status) + last_words(result.err);
    }
    return {};
}

}  // namespace jw::exercises
