#pragma once

#include <string>

#include "app/exercises/run/languages.hpp"

/// What went wrong with the program of a student, in the language of the reader and safe for a terminal.
namespace jw {

/// How a run ended if not well: "The program was stopped: ..."; empty if it succeeded.
std::string program_fault(const exercises::SandboxResult& result, const exercises::SandboxLimits& limits);

/// Why a program is not ready.
/// @param file  its name
std::string unready_text(const exercises::ReadyProgram& program, const std::string& file);

}  // namespace jw
