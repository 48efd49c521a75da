#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "app/exercises/run/sandbox.hpp"
#include "app/exercises/run/student_file.hpp"

namespace jw::exercises {

/// A language that students may write in. Shell scripts are not accepted: the programs that they call are not
/// the student's work.
struct Language {
    std::string_view extension;
    std::string_view name;
    std::string_view tool;     ///< the interpreter or compiler, by its full path
    std::string_view package;  ///< the Debian package that has it
    /// Arguments of the tool: FILE stands for the file, PROGRAM for the compiled program.
    std::array<std::string_view, 8> arguments;
    bool compiled = false;
    std::uint64_t address_bytes = 4ULL << 30U;  ///< address space that it reserves, used or not
};

inline constexpr std::array kLanguages{
    // without the file's folder in the search path, and without environment variables
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
    // reserves all the address space that it could ever use
    Language{".js", "JavaScript", "/usr/bin/node", "nodejs", {"FILE"}, false, 64ULL << 30U}};

/// The language of an extension, which includes the dot; nullptr if there is none.
const Language* language_of(std::string_view extension);

/// Reason why a language cannot be run on this machine, as one sentence; empty if it can.
std::string missing_tool(const Language& language);

struct ProgramResult {
    enum class Outcome {
        ran,           ///< with or without success: see `run`
        not_found,     ///< there is no such file
        refused,       ///< the file is not one that may be run
        no_tool,       ///< this machine lacks the interpreter or compiler
        not_compiled,  ///< the compiler reports errors
        no_sandbox     ///< without a sandbox nothing is run
    };
    Outcome outcome = Outcome::ran;
    std::string message;  ///< if it did not run: why, as text that is safe for a terminal
    SandboxResult run;    ///< if it ran
};

/// A program that can be run once or many times; it is compiled if its language is.
struct ReadyProgram {
    ProgramResult::Outcome outcome = ProgramResult::Outcome::ran;  ///< anything else: there is no program
    std::string message;     ///< why there is none; what the compiler reports, empty if it failed itself
    SandboxResult compiler;  ///< how the compiler failed, with its limits
    SandboxLimits limits;
    std::string command;  ///< full path of the program that is started in the sandbox
    std::vector<std::string> arguments;
    SandboxFile file;
    std::uint64_t address_bytes = 0;
};

/// Longest time that make_ready and run_ready can take together [s], even if the sandbox is set up slowly.
double longest_program_seconds();

/// Compiles in the sandbox, with its own limits, if needed. Takes about a second for C++ and no time
/// otherwise.
/// @param stop  stops a running compiler: then there is no program
ReadyProgram make_ready(const StudentProgram& program, const std::stop_token& stop = {});

/// Runs a program that is ready; `limits.address_bytes` is replaced by that of its language.
/// @param stop  kills the program: then there is no result
ProgramResult run_ready(
    const ReadyProgram& program, const std::string& input_json, SandboxLimits limits = {},
    const std::stop_token& stop = {});

/// Reads, compiles if needed, and runs the program of a file.
ProgramResult run_program(
    const std::string& file, const std::string& input_json, const SandboxLimits& limits = {});

}  // namespace jw::exercises
