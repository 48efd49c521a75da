#pragma once

/// Address space for Mesa's allocations.
namespace jw::render {

/// Checks that the address space that Mesa's software renderer needs for a picture of this size is available.
/// If it is not (ulimit -v), Mesa ends the program instead of reporting an error.
/// @throws std::runtime_error with the amount that is needed
void check_address_space(int width, int height);

}  // namespace jw::render
