#pragma once

#include <string>

#include "app/exercises/run/languages.hpp"

/// Faults of students' programs as sentences, in the language of the reader and safe for a terminal.
namespace jw {

/// Fault of a run: "The program was stopped: ..."; empty if it succeeded.
std::string program_fault(const exercises::SandboxResult& result, const exercises::SandboxLimits& limits);

/// Reason why a program is not ready to run.
/// @param file  its name
std::string unready_text(const exercises::ReadyProgram& program, const std::string& file);

}  // namespace jw
