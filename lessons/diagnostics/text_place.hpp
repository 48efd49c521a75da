#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Places within the texts of a lesson file.
namespace jw {

/// A piece of one line of a lesson file. Line and column count from 1, the column in characters (code
/// points); line 0: the file as a whole.
struct SourceSpan {
    int line = 0;
    int column = 0;
    int length = 0;  ///< characters, at least 1 where there is a line

    bool operator==(const SourceSpan&) const = default;
};

/// Place of byte `at` of the text whose quotes open at `start`: escapes, line feeds and the omitted first
/// line feed of a text in three quotes are counted as TOML reads them. Where this is not known, `start`
/// itself.
SourceSpan place_in_text(std::string_view source, const SourceSpan& start, std::size_t at);

/// A number as it is typed at a place, without underscores; empty if there is none.
std::string number_at(std::string_view source, const SourceSpan& start);

}  // namespace jw
