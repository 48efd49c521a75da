#pragma once

#include <string>
#include <vector>

#include "core/numerics/linear.hpp"

/// Reads the answers of a program.
namespace jw {

struct ProgramOutput {
    /// One per case; a list becomes a column, what is not finite becomes NaN. Empty: there are no such
    /// answers.
    std::vector<MatrixX> answers;
    std::string problem;  ///< why there are none, and what was expected; empty if there are
};

/// Reads {"answers": [...]}: numbers, lists of numbers and lists of rows. NaN and infinity are read as
/// Python, C++ (nan, inf) or JavaScript and Octave (null) write them: JSON has no word for them, and the
/// other answers should still be read.
ProgramOutput read_program_output(const std::string& text);

}  // namespace jw
