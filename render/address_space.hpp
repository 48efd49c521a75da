#pragma once

/// Room for what Mesa allocates.
namespace jw::render {

/// Checks that Mesa's software renderer will find the address space that it takes for a picture of this size:
/// where it does not (ulimit -v), it ends the program instead of reporting that.
/// @throws std::runtime_error with how much is needed
void check_address_space(int width, int height);

}  // namespace jw::render
