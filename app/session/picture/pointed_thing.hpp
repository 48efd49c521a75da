#pragma once

#include <optional>

#include "app/session/picture/pointable.hpp"
#include "app/session/view/view.hpp"

/// What a question means by the place that was clicked, and where an answer is to be seen.
namespace jw {

/// The thing of kind `wanted` at a place of a step's picture or panels: of a vector also its joint, of a
/// column of the matrix its body, of a symbol what it stands for; nothing where there is none of that kind.
std::optional<Thing> thing_at(const Step& step, const View& view, const Pointable& place, Thing::Kind wanted);

/// Where a thing is at a step: of a row that the system has not, the equation of its joint; nothing for the
/// row of a driver that is not added.
Pointable place_of(const Step& step, const Thing& thing);

/// At the answer to a question about things: lights up those that were right.
void light_answer(const Step& step, CoordinateChoice coordinates, const View& view, Emphasis& lit);

}  // namespace jw
