#pragma once

#include <string>

#include "app/session/view/view.hpp"

namespace jw {

/// A view as text for a terminal: everything that matters for this kind of step, in lines of at most `width`
/// characters where words allow.
std::string describe(const View& view, int width = 100);

struct RestView;
/// An equilibrium as text for a terminal.
std::string describe(const RestView& view);

}  // namespace jw
