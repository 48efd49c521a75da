#pragma once

#include <ostream>

#include "lessons/explanations/explanations.hpp"

/// Pages about the codes of diagnostics and their forms.
namespace jw {

/// All codes with their titles.
void write_list(std::ostream& out);
/// The page about a code, for a terminal.
void write_page(const Explanation& page, std::ostream& out);
/// Of all pages this is docs/diagnostics.md.
void write_markdown(const std::vector<Explanation>& pages, std::ostream& out);
/// docs/command-line.md describes the keys.
void write_json(const std::vector<Explanation>& pages, std::ostream& out);

}  // namespace jw
