#pragma once

#include <string>
#include <vector>

#include "core/numerics/linear.hpp"

/// The answers of a program, read.
namespace jw {

struct ProgramOutput {
    /// One for each case; a list is a column, what is not finite is NaN. Empty: it is none of these.
    std::vector<MatrixX> answers;
    std::string problem;  ///< why there are none, and what was expected; empty if there are
};

/// Reads {"answers": [...]}: numbers, lists of numbers and lists of rows. NaN and infinity may be written as
/// Python, C++ (nan, inf) or JavaScript and Octave (null) write them: JSON has no word for them, and the
/// other answers are worth reading.
ProgramOutput read_program_output(const std::string& text);

}  // namespace jw
