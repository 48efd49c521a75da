#pragma once

#include <functional>

#include "app/host/ui/ui.hpp"

namespace jw::host {

/// Draws into a part of the window what may be higher than it: then the wheel over it, its visible bar and
/// the commands of the panel move it.
/// @param height  of what is drawn; `draw` gets a box of that height
void scrolled(
    const Ui& ui, const panels::Box& box, float height, Scroll& scroll,
    const std::function<void(const panels::Canvas&, const panels::Box&)>& draw);

}  // namespace jw::host
