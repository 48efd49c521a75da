#pragma once

#include "render/animation/animation.hpp"
#include "render/animation/colour_table.hpp"

namespace jw::render {

/// One less than the format has room for: the last one means that a pixel stays as it is.
inline constexpr int kMostColoursOfGif = 255;

/// GIF in these colours, all pictures in the same. What shines through becomes opaque. The same pictures give
/// the same bytes.
/// @throws std::invalid_argument unless there are 1 to 255 colours
std::unique_ptr<Animation> make_gif(std::vector<Rgb> colours, Repeat repeat);

}  // namespace jw::render
