#pragma once

#include <string>
#include <vector>

#include "lessons/diagnostics/diagnostics.hpp"

namespace jw::fuzz {

/// Promises that every diagnostic is at a place of `source` (or of the file as a whole, line 0), and that all
/// can be printed.
void promise_places(const std::vector<Diagnostic>& diagnostics, const std::string& source);

/// Whether one of them is an error.
bool has_error(const std::vector<Diagnostic>& diagnostics);

/// Promises that "answers.toml:3:5: error: ..." lines of a report name places of `source`.
void promise_reported_places(const std::string& report, const std::string& source);

}  // namespace jw::fuzz
