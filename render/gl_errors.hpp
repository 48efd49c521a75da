#pragma once

#include <string>

#include "render/gl_functions.hpp"

/// Errors of GL stay until somebody asks for them, whichever call they came from: they are asked for where a
/// frame ends, so that none is blamed on a call of the next one.
namespace jw::render {

/// Takes all errors that are waiting. The context must be current.
/// @return the first of them in words, "OpenGL error 0x502 (invalid operation)"; empty if there is none
std::string take_gl_errors(const GlFunctions& gl);

/// @throws std::runtime_error "`during` failed with OpenGL error ..." if one is waiting
void throw_on_gl_error(const GlFunctions& gl, const char* during);

}  // namespace jw::render
