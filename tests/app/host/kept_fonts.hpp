#pragma once

#include "render/fonts/fonts.hpp"

namespace jw::test {

/// Letters for the current ImGui context as render::load_fonts loads them, which takes as long as a hundred
/// frames: those that were loaded before in this process are shared, and stay.
render::Fonts kept_fonts(float scale, std::u32string_view others, render::AtlasSize size);

}  // namespace jw::test
