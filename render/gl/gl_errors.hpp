#pragma once

#include <string>

#include "render/gl/gl_functions.hpp"

/// GL keeps errors until they are read, whichever call caused them. They are read at the end of a frame, so
/// that they are not blamed on a call of the next frame.
namespace jw::render {

/// Reads and clears all waiting errors. The context must be current.
/// @return the first of them in words, "OpenGL error 0x502 (invalid operation)"; empty if there is none
std::string take_gl_errors(const GlFunctions& gl);

/// @throws std::runtime_error "`during` failed with OpenGL error ..." if one is waiting
void throw_on_gl_error(const GlFunctions& gl, const char* during);

}  // namespace jw::render
