#pragma once

#include <string>

#include "render/files/image.hpp"

/// Pictures of windows that were looked at. `./dev golden` draws them anew; look at each before it is
/// committed. They are compared as the colours of snapshots are, by the same rules.
namespace jw::test {

/// True where golden pictures are drawn anew instead of compared.
bool draws_goldens();

/// Checks that the picture is the golden one, or draws that anew.
/// @param file  below the root of the sources
void compare_with_golden(const std::string& file, const render::Image& now);

/// The rule of golden snapshots that two pictures break; empty if none is.
std::string broken_rule_of(const render::Image& then, const render::Image& now);

}  // namespace jw::test
