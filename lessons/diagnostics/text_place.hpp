#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "lessons/diagnostics/source_span.hpp"

/// Places within the texts of a lesson file.
namespace jw {

/// Place of byte `at` of the text whose quotes open at `start`: escapes, line feeds and the omitted first
/// line feed of a text in three quotes are counted as TOML reads them. Where this is not known, `start`
/// itself.
SourceSpan place_in_text(std::string_view source, const SourceSpan& start, std::size_t at);

/// A number as it is typed at a place, without underscores; empty if there is none.
std::string number_at(std::string_view source, const SourceSpan& start);

}  // namespace jw
