#pragma once

#include <string>
#include <vector>

#include "lessons/diagnostics.hpp"
#include "lessons/read_text.hpp"

/// What the languages of a file lack.
namespace jw {

/// A warning for each language that some texts of the file have and others have not, at the first of these:
/// how many they are, and where. Texts that only authors see need no translation.
std::vector<Diagnostic> missing_translations(const std::string& file, const std::vector<ReadText>& texts);

}  // namespace jw
