#pragma once

#include "render/animation/animation.hpp"
#include "render/animation/colour_table.hpp"

namespace jw::render {

/// Largest number of colours, one less than the format allows: the last index stands for an unchanged pixel.
inline constexpr int kMostColoursOfGif = 255;

/// GIF with these colours, the same for all pictures. Transparent pixels become opaque. The same pictures
/// give the same bytes.
/// @throws std::invalid_argument unless there are 1 to 255 colours
std::unique_ptr<Animation> make_gif(std::vector<Rgb> colours, Repeat repeat);

}  // namespace jw::render
