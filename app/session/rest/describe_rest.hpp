#pragma once

#include <string>

#include "app/session/output/json.hpp"
#include "app/session/rest/rest.hpp"

namespace jw {

/// An equilibrium as text for a terminal.
std::string describe(const RestView& view);
/// docs/command-line.md describes the layout.
Json json_of(const RestView& view, const Lesson& lesson);

}  // namespace jw
