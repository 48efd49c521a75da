#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/kinematics/proof/proof_record.hpp"
#include "lessons/diagnostics/diagnostics.hpp"
#include "lessons/lesson/lesson.hpp"

/// Parts that all commands share: exit status, streams, errors in the command line.
namespace jw {

/// Exit status of the program.
enum class Exit {
    done = 0,
    check_failed = 1,
    bad_input = 2,  ///< bad usage, a lesson with mistakes, a folder that cannot be written
    numerics = 3,   ///< the numerical methods failed
};

/// Ends a command; `what()` is written to standard error unchanged.
class CommandError : public std::runtime_error {
public:
    CommandError(Exit exit, const std::string& message) : std::runtime_error(message), exit_(exit) {}
    Exit exit() const { return exit_; }

private:
    Exit exit_;
};

/// The file has mistakes; `what()` is the report about them.
class FaultyFile : public CommandError {
public:
    FaultyFile(const std::string& report, std::vector<Diagnostic> diagnostics)
        : CommandError(Exit::bad_input, report), diagnostics_(std::move(diagnostics)) {}
    const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

private:
    std::vector<Diagnostic> diagnostics_;
};

/// Error in the input of a command. @param hint  may be empty
CommandError bad_input(const std::string& message, const std::string& hint = {});
/// Error in an option of a command, with a hint at its help.
CommandError bad_option(const std::string& command, const std::string& message);

/// Names of things, or of the entries of a table.
template <class Things>
std::vector<std::string> names_of(const Things& things) {
    std::vector<std::string> names;
    for (const auto& thing : things) { names.emplace_back(thing.name); }
    return names;
}

/// Place of a name in a list. @throws CommandError (bad_input): `fault`, the names, and a similar one
std::size_t place_in(
    const std::vector<std::string>& names, const std::string& name, const std::string& fault);

/// Makes a folder with those that it lies in. @throws CommandError (bad_input)
void make_folder(const std::filesystem::path& folder);

/// Streams that a command writes to; tests pass their own.
struct Streams {
    std::ostream& out;
    std::ostream& err;
    bool err_is_terminal = false;
    /// True if `out` or `err` is redirected into that file; empty: never.
    std::function<bool(const std::filesystem::path&)> goes_into = {};
    /// The file of the running program and its arguments, to start it again; empty: it cannot be started
    /// again.
    std::vector<std::string> command_line = {};
};

/// Reads the lesson in `path`; warnings go to `streams.err`.
/// @throws FaultyFile with all diagnostics of the file; CommandError (bad_input) if `streams` go into it
Lesson lesson_of(const std::filesystem::path& path, const Streams& streams);

/// Checks an output before anything is computed: it must be writable, and must not be one of the files that
/// are read, under any name, link or not. Fonts count, too, since everything that draws reads them.
/// @param option  names the output
/// @throws CommandError (bad_input) or std::runtime_error
void check_output(
    const std::string& option, const std::filesystem::path& output,
    const std::vector<std::filesystem::path>& inputs);

/// True if `path` is the regular file that standard output or standard error is redirected into.
bool is_own_output(const std::filesystem::path& path);

/// Writes a proof for docs/proofs/check_proof.py: JSON in one line. The last key `sha256` is the hash of the
/// text before it, so that a damaged file can be told from a wrong proof.
void write_proof(
    const std::filesystem::path& file, const ProofRecord& proof, const System& system, const Lesson& lesson);

/// Validator for CLI11's `check`: says what is wrong with a whole number below 0; empty if nothing is.
std::string fault_of_step(const std::string& text);

/// Refuses a step after the last one of a lesson. @throws CommandError (bad_input)
void check_step(const std::string& option, int step, int last);

/// A progress bar on a terminal, nothing elsewhere; it disappears when it is destroyed.
class ProgressBar {
public:
    ProgressBar(const Streams& streams, std::string what);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    void show(double fraction);

private:
    const Streams* streams_;
    std::string what_;
    int shown_ = -1;
};

}  // namespace jw
