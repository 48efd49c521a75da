#pragma once

#include <string>
#include <vector>

#include "core/equations/system.hpp"

/// Names of rows, columns and equations as people read them; the only place where their origin becomes text.
namespace jw {

struct EquationText {
    std::string primitive;  ///< "p1"
    std::string formula;    ///< as docs/mathematics.md says
    std::string plain;      ///< the same in one line of Unicode
    std::string unit;       ///< "m", "m²" or "-"
};

std::string name_of_role(Role role, ParallelForm form);
EquationText equation_text(const System& system, const Constraint& constraint);
EquationText driver_text(const Driver& driver);

/// The constraint that a row belongs to; nullptr for a row of a driver or a normalisation.
const Constraint* constraint_of(const System& system, int row);

/// "hinge · p1 · y"
std::string row_label(const System& system, int row);
/// The joint, driver or body that a row belongs to.
std::string row_owner(const System& system, int row);
/// Short form for the margin of a matrix: "p1 y".
std::string short_row_label(const System& system, int row);
/// "x", "y", "z", or "1", "2" for the two rows of a pair; empty for a single equation.
std::string component_name(const Constraint& constraint, int component);

struct ColumnName {
    std::string owner;       ///< body or joint
    std::string coordinate;  ///< "x", "e0", "omega_local.x", "theta"
    std::string symbol;      ///< "x", "e₀", "ω′x", "θ"
};
std::vector<ColumnName> column_names(const System& system, CoordinateChoice choice);

const char* name_of_choice(CoordinateChoice choice);  ///< "rp-modified", as on the command line
const char* name_of_form(ParallelForm form);          ///< "drop x", as in a lesson
const char* axis_name(int component);                 ///< "x", "y", "z"

}  // namespace jw
