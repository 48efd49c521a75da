#include "app/exercises/grading/fault_text.hpp"

#include <cstdio>
#include <cstring>

#include "app/exercises/run/safe_text.hpp"
#include "app/session/wording/messages.hpp"

namespace jw {

namespace {

std::string megabytes(std::uint64_t bytes) {
    constexpr std::uint64_t kilo = 1U << 10U;
    return bytes < kilo * kilo ? std::to_string(bytes / kilo) + " kB"
                               : std::to_string(bytes / kilo / kilo) + " MB";
}

/// A limit in seconds; fractions matter only in tests.
std::string in_seconds(double seconds) {
    char text[32];
    std::snprintf(text, sizeof text, "%g s", seconds);
    return text;
}

/// The program's message about its end: the last line that calls itself an error ("NameError: ...", "error:
/// ..."), or else the last line. Octave and JavaScript write the place of the error after it.
std::string last_words(const std::string& err) {
    std::string text = exercises::printable(err);
    while (text.ends_with('\n') || text.ends_with(' ')) { text.pop_back(); }
    constexpr std::string_view kOctavesPlace = "\nerror: called from";
    text = text.substr(0, text.find(kOctavesPlace));
    const std::size_t line = text.rfind('\n', text.rfind("rror: "));
    const std::string last = line == std::string::npos ? text : text.substr(line + 1);
    return last.empty() ? last : ": " + exercises::first_lines(last.substr(0, last.find('\n')), 1, 200);
}

/// @param who  "The program" or "The compiler"
std::string fault_of(
    const std::string& who, const exercises::SandboxResult& result, const exercises::SandboxLimits& limits) {
    if (!result.could_not_run.empty()) { return tr("{0} was not run: {1}", who, result.could_not_run); }
    if (result.too_much_output) {
        return tr(
            "{0} was stopped: it wrote more than {1} to standard output, or {2} to standard error", who,
            megabytes(limits.out_bytes), megabytes(limits.err_bytes));
    }
    if (result.out_of_memory) {
        return tr("{0} needs more memory than the {1} allowed", who, megabytes(limits.memory_bytes));
    }
    if (result.too_many_files) {
        return tr("{0} was stopped: it made more than {1} files", who, limits.tmp_files);
    }
    if (result.timed_out) {
        return tr(
            "{0} was stopped: it took more than {1} of processor time or {2} of elapsed time", who,
            in_seconds(limits.cpu_seconds), in_seconds(limits.wall_seconds));
    }
    if (result.signal != 0) {
        return tr("{0} was ended by a signal ({1})", who, ::strsignal(result.signal)) +
               last_words(result.err);
    }
    if (result.exit_status != 0) {
        return tr("{0} ended with status {1}", who, result.exit_status) + last_words(result.err);
    }
    return {};
}

}  // namespace

std::string program_fault(const exercises::SandboxResult& result, const exercises::SandboxLimits& limits) {
    return fault_of(tr("The program"), result, limits);
}

std::string unready_text(const exercises::ReadyProgram& program, const std::string& file) {
    if (program.outcome != exercises::ProgramResult::Outcome::not_compiled) { return program.message; }
    const std::string why = program.message.empty()
                                ? fault_of(tr("The compiler"), program.compiler, program.limits)
                                : program.message;
    return tr("'{0}' cannot be compiled:\n{1}", file, why);
}

}  // namespace jw
