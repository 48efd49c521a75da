#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace jw::render {

/// Looks at a PNG before a decoder trusts its lengths: a few bytes can claim chunks and pixels that take more
/// memory than there is. Whether its pixels are right is left to the decoder.
/// @return what is wrong: no head, a chunk that is longer than the file, pixels that unpack to more than the
/// head says; empty
///         if nothing is
std::string fault_of_png(std::span<const std::uint8_t> bytes);

}  // namespace jw::render
