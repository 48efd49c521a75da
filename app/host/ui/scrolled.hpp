#pragma once

#include <functional>

#include "app/host/ui/ui.hpp"

namespace jw::host {

/// Draws content that may be higher than its part of the window. It is then scrolled by the wheel, the scroll
/// bar and the commands of the panel.
/// @param height  of the content; `draw` gets a box of that height
void scrolled(
    const Ui& ui, const panels::Box& box, float height, Scroll& scroll,
    const std::function<void(const panels::Canvas&, const panels::Box&)>& draw);

}  // namespace jw::host
