#pragma once

#include "app/panels/parts/parts.hpp"
#include "app/session/view/view.hpp"

namespace jw::panels {

/// The equations as on the page, with the value of every component: filled squares are kept, hollow ones with
/// a grey value left out, a hatched one repeats others.
/// @return height taken
float equations_panel(
    const Canvas& canvas, const Box& box, const std::vector<EquationGroup>& equations, Density density);

/// Which of three equations are kept and why, in three columns under the components: the size of each
/// component of s, and the condition that the other two equations have.
float choice_table(const Canvas& canvas, const Box& box, const ChoiceView& choice, Density density);

}  // namespace jw::panels
