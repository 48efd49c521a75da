#pragma once

#include <map>
#include <string>

namespace jw::host {

/// The program, its libraries and the fonts, with their versions. Pictures depend on them as well as on the
/// lesson.
using Environment = std::map<std::string, std::string>;

/// Hashes of the font files. Reading the files takes ten milliseconds.
Environment font_environment();

/// Environment of this process: versions of the program and of FreeType, renderer with LLVM and Mesa, fonts.
/// @param renderer  as OpenGL names it
/// @param fonts     a `font_environment`
Environment environment(const std::string& renderer, Environment fonts = font_environment());

/// Differences that pictures can show between two environments, in words: "renderer: llvmpipe (LLVM 14)
/// before, llvmpipe (LLVM 15) now"; empty if there are none.
std::string environment_change(const Environment& before, const Environment& now);

}  // namespace jw::host
