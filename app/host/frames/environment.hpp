#pragma once

#include <map>
#include <string>

namespace jw::host {

/// Things that pictures depend on besides the lesson: the program and what it draws with, with their
/// versions.
using Environment = std::map<std::string, std::string>;

/// Fonts by what is in their files, which takes ten milliseconds to read.
Environment font_environment();

/// Environment of this process: versions of the program and of FreeType, renderer with LLVM and Mesa, fonts.
/// @param renderer  as OpenGL names it
/// @param fonts     a `font_environment`
Environment environment(const std::string& renderer, Environment fonts = font_environment());

/// Differences between two environments, in words: "renderer: llvmpipe (LLVM 14) before, llvmpipe (LLVM 15)
/// now"; empty if nothing does.
std::string environment_change(const Environment& before, const Environment& now);

}  // namespace jw::host
