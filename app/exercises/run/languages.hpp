#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "app/exercises/run/sandbox.hpp"
#include "app/exercises/run/student_file.hpp"

namespace jw::exercises {

/// A language that students may write in. A program of a shell is not among them: what it calls is not the
/// student's.
struct Language {
    std::string_view extension;
    std::string_view name;
    std::string_view tool;     ///< the interpreter or compiler, by its full path
    std::string_view package;  ///< of Debian, that has it
    /// What follows the tool: the file takes the place of FILE, the compiled program that of PROGRAM.
    std::array<std::string_view, 8> arguments;
    bool compiled = false;
    std::uint64_t address_bytes = 4ULL << 30U;  ///< what it reserves, used or not
};

inline constexpr std::array kLanguages{
    // without the folder of the file and without variables of the environment
    Language{".py", "Python", "/usr/bin/python3", "python3", {"-I", "FILE"}},
    Language{
        ".cpp",
        "C++",
        "/usr/bin/g++",
        "g++",
        {"-O1", "-std=c++20", "-fmax-errors=5", "-I/usr/include/eigen3", "-o", "PROGRAM", "FILE"},
        true},
    Language{
        ".m",
        "Octave",
        "/usr/bin/octave-cli",
        "octave",
        {"--no-gui", "--norc", "--no-history", "-q", "FILE"}},
    // reserves address space for all that it could ever use
    Language{".js", "JavaScript", "/usr/bin/node", "nodejs", {"FILE"}, false, 64ULL << 30U}};

/// By its extension with the dot; none if there is no such language.
const Language* language_of(std::string_view extension);

/// Why a language cannot be run on this machine, as one sentence; empty if it can.
std::string missing_tool(const Language& language);

struct ProgramResult {
    enum class Outcome {
        ran,           ///< well or not: see `run`
        not_found,     ///< there is no such file
        refused,       ///< the file is none that is run
        no_tool,       ///< this machine lacks the interpreter or compiler
        not_compiled,  ///< the compiler objects
        no_sandbox     ///< nothing is run without
    };
    Outcome outcome = Outcome::ran;
    std::string message;  ///< unless it ran: why, as text that a terminal may show
    SandboxResult run;    ///< if it ran
};

/// A program that can be run, once or many times: compiled if its language is.
struct ReadyProgram {
    ProgramResult::Outcome outcome = ProgramResult::Outcome::ran;  ///< anything else: there is none
    std::string message;     ///< why there is none; what the compiler objects to, empty if it failed itself
    SandboxResult compiler;  ///< how it failed, with its limits
    SandboxLimits limits;
    std::string command;  ///< the full path of what is started in the sandbox
    std::vector<std::string> arguments;
    SandboxFile file;
    std::uint64_t address_bytes = 0;
};

/// The longest that make_ready and run_ready can take together [s], where the sandbox is set up slowly, too.
double longest_program_seconds();

/// Compiles in the sandbox, with limits of its own, if needed. Takes about a second for C++ and no time
/// otherwise.
/// @param stop  gives up a compiler that runs: there is no program then
ReadyProgram make_ready(const StudentProgram& program, const std::stop_token& stop = {});

/// Runs a program that is ready; `limits.address_bytes` is replaced by that of its language.
/// @param stop  kills it: the result is none then
ProgramResult run_ready(
    const ReadyProgram& program, const std::string& input_json, SandboxLimits limits = {},
    const std::stop_token& stop = {});

/// Reads, compiles if needed, and runs the program of a file.
ProgramResult run_program(
    const std::string& file, const std::string& input_json, const SandboxLimits& limits = {});

}  // namespace jw::exercises
