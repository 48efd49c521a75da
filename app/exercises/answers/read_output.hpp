#pragma once

#include <string>
#include <vector>

#include "core/numerics/linear.hpp"

/// Reads the answers of a program.
namespace jw {

struct ProgramOutput {
    /// One for each case. A list becomes a column, NaN and infinity become NaN; anything but a number, a list
    /// of numbers or a list of rows becomes an empty matrix.
    std::vector<MatrixX> answers;
    std::string problem;  ///< why there are no answers, and what was expected; empty if there are
};

/// Reads {"answers": [...]}: numbers, lists of numbers and lists of rows. NaN and infinity are read as
/// Python, C++ (nan, inf) or JavaScript and Octave (null) write them: JSON has no word for them, and the
/// other answers should still be read.
ProgramOutput read_program_output(const std::string& text);

}  // namespace jw
