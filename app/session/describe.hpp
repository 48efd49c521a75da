#pragma once

#include <string>

#include "app/session/view.hpp"

/// Views as text for a terminal.
namespace jw {

/// Everything of a step that matters to its kind, in lines of at most `width` characters where words allow.
std::string describe(const View& view, int width = 100);

/// `text` broken at spaces, every line after the first indented by `indent` spaces.
std::string wrapped(const std::string& text, int width, int indent);

/// Characters of UTF-8 text as seen: combining marks count nothing.
int displayed_width(const std::string& text);

/// `text` with spaces after (or, to the right, before) it up to `width` characters as seen.
std::string padded(const std::string& text, int width, bool right = false);

}  // namespace jw
