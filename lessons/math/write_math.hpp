#pragma once

#include <string>

#include "lessons/math/math.hpp"

/// Formulas for terminals, for LaTeX and Markdown, and for HTML, all from the tree of math.hpp.
namespace jw::math {

/// One line of Unicode: "s̃ᵢ sⱼ = 0". Scripts that Unicode does not have as small letters keep _ and ^.
std::string write_plain(const Row& row);
/// LaTeX that needs only amsmath, without delimiters; ASCII.
std::string write_latex(const Row& row);
/// A `math` element of MathML Core.
/// @param display  as a line of its own
std::string write_mathml(const Row& row, bool display);

}  // namespace jw::math
