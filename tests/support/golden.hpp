#pragma once

#include <string>

#include "render/files/image.hpp"

/// Golden pictures of windows, each checked by eye. `./dev golden` draws them again; look at each before it
/// is committed. They are compared by the same rules as the colours of snapshots.
namespace jw::test {

/// True where golden pictures are drawn again instead of being compared.
bool draws_goldens();

/// Checks that the picture is the golden one, or draws the golden one again.
/// @param file  below the root of the sources
void compare_with_golden(const std::string& file, const render::Image& now);

/// The rule of golden snapshots that two pictures break; empty if none is.
std::string broken_rule_of(const render::Image& then, const render::Image& now);

}  // namespace jw::test
