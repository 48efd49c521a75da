#pragma once

#include "app/panels/parts/parts.hpp"
#include "app/session/view/view.hpp"

namespace jw::panels {

/// The equations as on paper, with the value of every component: a filled square for a kept one, a hollow
/// square with a grey value for one that is left out, a hatched square for a redundant one.
/// @return height taken
float equations_panel(
    const Canvas& canvas, const Box& box, const std::vector<EquationGroup>& equations, Density density);

/// Which of three equations are kept, and why, in three columns under the components: the size of each
/// component of s, and the condition of the other two equations.
float choice_table(const Canvas& canvas, const Box& box, const ChoiceView& choice, Density density);

}  // namespace jw::panels
