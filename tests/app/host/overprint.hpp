#pragma once

#include <string>
#include <vector>

#include "app/host/host.hpp"

namespace jw::test {

/// Letters of the frame drawn last that nobody can read: printed over other letters, covered by what is drawn
/// later in the same layer, or cut by an edge where nothing scrolls. Found by drawing the frame's triangles
/// into memory, letter by letter, with the pixels of the fonts.
/// @return one sentence for each place, with its pixels; empty if all can be read
std::vector<std::string> unreadable_letters();

}  // namespace jw::test
