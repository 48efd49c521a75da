#pragma once

#include "app/session/view/view.hpp"

/// Views filled by hand: panels need no solver.
namespace jw::panels::test {

/// A four-bar while its last joint is added: 20 rows, 18 columns, three redundant.
View four_bar(Step::Kind kind);

/// A screw: four groups of equations, two choices, six rows and θ.
View screw(Step::Kind kind);

/// Nothing yet: bodies and no equations.
View only_bodies(Step::Kind kind);

/// View in which every text is as long, and every list has as many entries, as a lesson may make it.
View overlong(Step::Kind kind);

}  // namespace jw::panels::test
