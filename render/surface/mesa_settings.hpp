#pragma once

/// Environment variables for Mesa that can make this program fail.
namespace jw::render {

/// Sets the environment so that Mesa's renderer `llvmpipe` can draw. Call it before Mesa is loaded, and
/// before other threads read the environment.
///
/// If LP_NATIVE_VECTOR_WIDTH is set, Mesa's cache on disk is switched off for this process: its keys do not
/// contain the width (Mesa 22.3.6), so shaders for registers of another width would be taken from the cache
/// and overwrite memory.
/// @throws std::runtime_error if LP_NATIVE_VECTOR_WIDTH is a number other than 128 and 256, because Mesa
/// would then end the program while it draws.
void settle_mesa();

/// Checks that the address space that Mesa's software renderer needs for a picture of this size is available.
/// If it is not (ulimit -v), Mesa ends the program instead of reporting an error.
/// @throws std::runtime_error with the amount that is needed
void check_address_space(int width, int height);

}  // namespace jw::render
