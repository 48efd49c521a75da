#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Finds the places of a source where one character makes a derivative wrong.
namespace jw::mutation {

enum class Kind {
    jet,     ///< a jet that a function returns: its first block, last block, rate or bias changes its sign
    value,   ///< a value given or added to something: it changes its sign
    term,    ///< what stands behind a + or - or is returned in brackets: it changes its sign
    number,  ///< a number with a decimal point: a quarter more
};

/// Mutants that one mark stands for.
constexpr int mutants_of(Kind kind) { return kind == Kind::jet ? 4 : 1; }

/// What is marked: the text [begin, end), of a term its beginning only.
struct Mark {
    Kind kind = Kind::term;
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// Marks of a source in their order. Comments, strings, preprocessor lines, constants known at compile time
/// and signs before whole numbers (indices) have none; 0.0 has none either.
/// @param jets whether jets that are returned are marked
std::vector<Mark> marks_of(std::string_view source, bool jets);

/// `source` with calls of switch.hpp at its marks, their mutants numbered from `first` on.
std::string marked(std::string_view source, const std::vector<Mark>& marks, int first);

/// The line around `at`, without its indentation.
std::string line_at(std::string_view source, std::size_t at);
int line_number_at(std::string_view source, std::size_t at);
/// Head of the function (or struct) of the top level around `at`, in one line.
std::string head_at(std::string_view source, std::size_t at);

}  // namespace jw::mutation
