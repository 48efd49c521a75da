#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Finds the places of a source where one character makes an answer wrong.
namespace jw::mutation {

enum class Kind {
    loop,    ///< the condition of a loop: it never holds
    branch,  ///< the condition of an if: it is negated
    jet,     ///< a jet that a function returns: its first block, last block, rate or bias changes its sign
    value,   ///< a value assigned or added to something: it changes its sign
    term,    ///< what stands behind a + or - or is returned in brackets: it changes its sign
    number,  ///< a number with a decimal point: it grows by a quarter
};

/// Mutants that one mark stands for.
constexpr int mutants_of(Kind kind) { return kind == Kind::jet ? 4 : 1; }

/// Marked text [begin, end); for a term only its beginning.
struct Mark {
    Kind kind = Kind::term;
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// Options: what is marked besides signs and numbers.
struct Besides {
    bool jets = false;      ///< jets that are returned
    bool branches = false;  ///< conditions of loops and ifs
};

/// Marks of a source in their order. Comments, strings, preprocessor lines, constants known at compile time
/// and signs before whole numbers or in square brackets (indices) have none; 0.0 has none either.
std::vector<Mark> marks_of(std::string_view source, const Besides& besides);

/// `source` with calls of switch.hpp at its marks, their mutants numbered from `first` on.
std::string marked(std::string_view source, const std::vector<Mark>& marks, int first);

/// The line around `at`, without its indentation.
std::string line_at(std::string_view source, std::size_t at);
int line_number_at(std::string_view source, std::size_t at);
/// Head of the function (or struct) of the top level around `at`, in one line.
std::string head_at(std::string_view source, std::size_t at);

}  // namespace jw::mutation
