#pragma once

#include <string>

#include "app/session/view/inspection.hpp"

namespace jw {

/// Φ, Φq and γ with labelled rows and named columns, the choice of rows and the rank, as text for a terminal.
std::string describe(const Inspection& inspection, const Lesson& lesson, int width = 100);

/// The equations of motion of slide 24: M and Q body by body, λ row by row, energies and momenta.
std::string describe(const DynamicsView& dynamics);

}  // namespace jw
