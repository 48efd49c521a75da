#pragma once

#include "render/passes/instances.hpp"
#include "render/scene/framing.hpp"

namespace jw::render {

/// Bounds of everything in the lists, slightly too large: the box around each instance.
Bounds bounds_of(const DrawLists& lists);

/// Pixels, in a picture 720 high, by which outlines and lines reach beyond `bounds_of` at most.
float border_of(const DrawLists& lists);

}  // namespace jw::render
