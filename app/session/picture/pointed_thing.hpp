#pragma once

#include <optional>

#include "app/session/picture/pointable.hpp"
#include "app/session/view/view.hpp"

/// The thing that a clicked place stands for, and the place where an answer is shown.
namespace jw {

/// The thing of kind `wanted` at a place of a step's picture or panels: for a vector also its joint, for a
/// column of the matrix its body, for a symbol what it stands for; nothing if there is none of that kind.
std::optional<Thing> thing_at(const Step& step, const View& view, const Pointable& place, Thing::Kind wanted);

/// Place of a thing at a step: for a row that the system does not have, the equation of its joint; nothing
/// for the row of a driver that is not added.
Pointable place_of(const Step& step, const Thing& thing);

/// Highlights the right things when the answer to a question about things is shown.
void light_answer(const Step& step, CoordinateChoice coordinates, const View& view, Emphasis& lit);

}  // namespace jw
