#pragma once

#include <ostream>

#include "lessons/explanations/explanations.hpp"

/// Pages about the codes of diagnostics, in several formats.
namespace jw {

/// All codes with their titles.
void write_list(std::ostream& out);
/// The page about a code, for a terminal.
void write_page(const Explanation& page, std::ostream& out);
/// For all pages, the result is docs/diagnostics.md.
void write_markdown(const std::vector<Explanation>& pages, std::ostream& out);
/// The keys are described in docs/command-line.md.
void write_json(const std::vector<Explanation>& pages, std::ostream& out);

}  // namespace jw
