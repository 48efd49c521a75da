#pragma once

#include <string>

namespace jw {

/// Frames A to B, both included, counted from 0.
struct FrameRange {
    int first = 0;
    int last = 0;
};

/// "3:7", "3:", ":7" or "3" within `frames` frames.
/// @throws CommandError for anything else
FrameRange frame_range(const std::string& text, int frames);

}  // namespace jw
