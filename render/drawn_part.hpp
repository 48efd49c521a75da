#pragma once

#include "render/framing.hpp"
#include "render/instances.hpp"

namespace jw::render {

/// Bounds of everything in the lists, a little wide: of each instance the box around it.
Bounds bounds_of(const DrawLists& lists);

/// Most pixels of a picture 720 high by which outlines and widths of lines reach beyond `bounds_of`.
float border_of(const DrawLists& lists);

}  // namespace jw::render
