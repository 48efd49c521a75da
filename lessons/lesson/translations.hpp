#pragma once

#include <string>
#include <vector>

#include "lessons/diagnostics/diagnostics.hpp"
#include "lessons/diagnostics/read_text.hpp"

/// Translations that are missing in a file.
namespace jw {

/// A warning for each language that only some texts of the file have. It is placed at the first text without
/// it, and says how many there are and where. Texts that only authors see need no translation.
std::vector<Diagnostic> missing_translations(const std::string& file, const std::vector<ReadText>& texts);

}  // namespace jw
