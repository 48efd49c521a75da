#pragma once

#include <string>
#include <vector>

#include "lessons/diagnostics/diagnostics.hpp"

namespace jw::fuzz {

/// Promises that every diagnostic has a place in `source` (line 0: the file as a whole) and can be printed.
void promise_places(const std::vector<Diagnostic>& diagnostics, const std::string& source);

/// True if one of them is an error.
bool has_error(const std::vector<Diagnostic>& diagnostics);

/// Promises that lines of a report such as "answers.toml:3:5: error: ..." name places in `source`.
void promise_reported_places(const std::string& report, const std::string& source);

}  // namespace jw::fuzz
