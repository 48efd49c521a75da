#pragma once

#include <string>

#include "app/snapshot/facts_file.hpp"

namespace jw::snapshot {

/// What pictures are drawn with here: versions of the program and of FreeType, renderer with LLVM and Mesa,
/// and the fonts by what is in their files.
/// @param renderer  as OpenGL names it
Environment environment(const std::string& renderer);

/// What differs between two environments, in words: "renderer: llvmpipe (LLVM 14) before, llvmpipe (LLVM 15)
/// now"; empty if nothing does.
std::string environment_change(const Environment& before, const Environment& now);

}  // namespace jw::snapshot
