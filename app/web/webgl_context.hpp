#pragma once

#include <memory>

#include "render/headless_context.hpp"

namespace jw::web {

/// Context of WebGL 2 of the page's canvas, which its own framebuffer is shown in.
/// @param canvas  its CSS selector
/// @throws std::runtime_error if the browser has none
std::unique_ptr<render::HeadlessContext> make_webgl_context(const char* canvas);

}  // namespace jw::web
