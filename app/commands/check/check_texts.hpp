#pragma once

#include <string>
#include <vector>

#include "lessons/diagnostics/diagnostics.hpp"
#include "lessons/diagnostics/read_text.hpp"

namespace jw {

/// Warnings about the texts of a file: texts missing in a language, and characters that no font has.
std::vector<Diagnostic> warnings_about_texts(const std::string& file, const std::vector<ReadText>& texts);

}  // namespace jw
