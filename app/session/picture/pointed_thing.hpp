#pragma once

#include <optional>

#include "app/session/picture/pointable.hpp"
#include "app/session/view/view.hpp"

/// What a question means by the place that was clicked.
namespace jw {

/// The thing of kind `wanted` at a place of a step's picture or panels: of a vector also its joint, of a
/// column of the matrix its body, of a symbol what it stands for; nothing where there is none of that kind.
std::optional<Thing> thing_at(const Step& step, const View& view, const Pointable& place, Thing::Kind wanted);

}  // namespace jw
