#pragma once

#include <memory>

#include "render/surface/headless_context.hpp"

namespace jw::web {

/// WebGL 2 context of the page's canvas, which shows the default framebuffer of the context.
/// @param canvas  its CSS selector
/// @throws std::runtime_error if the browser has no WebGL 2
std::unique_ptr<render::HeadlessContext> make_webgl_context(const char* canvas);

}  // namespace jw::web
