#pragma once

#include <string>

#include "app/session/view/derivation.hpp"
#include "app/session/view/inspection.hpp"
#include "app/session/view/view.hpp"

namespace jw {

/// A view as text for a terminal: everything that matters for this kind of step, in lines of at most `width`
/// characters where words allow.
std::string describe(const View& view, int width = 100);

/// Φ, Φq and γ with labelled rows and named columns, the choice of rows and the rank, as text for a terminal.
std::string describe(const Inspection& inspection, const Lesson& lesson, int width = 100);

/// The equations of motion of slide 24: M and Q body by body, λ row by row, energies and momenta.
std::string describe(const DynamicsView& dynamics);

struct RestView;
/// An equilibrium as text for a terminal.
std::string describe(const RestView& view);

/// The same texts for a narrow column.
struct RestWords {
    struct SmallMotion {
        std::string in_time;  ///< frequency, growth or decay
        std::string joints;   ///< that move most
    };
    std::string verdict;                  ///< whether it is stable
    std::vector<std::string> quantities;  ///< "hinge.angle 30 deg"
    std::vector<SmallMotion> motions;     ///< one per mode
};
RestWords words_of(const RestView& view);

// text beside the pointer, line by line, with formulas between dollar signs

/// Lines about a symbol: its meaning, and its value for each thing that it can stand for.
std::vector<std::string> symbol_tip(const SymbolView& symbol);

/// The formula of a block of Φq, the formula with its numbers, and the row of the entry.
std::vector<std::string> derivation_tip(const Derivation& derivation);

}  // namespace jw
