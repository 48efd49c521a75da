#pragma once

/// Variables of the environment that Mesa obeys at the price of the program.
namespace jw::render {

/// Makes the environment one in which Mesa's renderer `llvmpipe` draws; call it before Mesa is loaded, and
/// before other threads read the environment.
///
/// With LP_NATIVE_VECTOR_WIDTH set, Mesa's cache on disk is switched off for this process: its keys leave the
/// width out (Mesa 22.3.6), so shaders for registers of another width would be taken from it and write over
/// memory.
/// @throws std::runtime_error if LP_NATIVE_VECTOR_WIDTH is a number other than 128 and 256: Mesa ends the
/// program
///         while it draws.
void settle_mesa();

}  // namespace jw::render
