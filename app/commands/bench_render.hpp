#pragma once

#include <string>
#include <vector>

#include "app/commands/command.hpp"
#include "app/commands/size_option.hpp"

namespace jw {

/// `jointwise bench --render`: what a picture of the motion costs, stage by stage, beside a plain loop that
/// draws, reads back and writes with stb_image_write alone.
/// @throws CommandError for what is no lesson, or has no motion
Exit bench_render(
    const std::vector<std::string>& scenes, const PixelSize& size, const std::string& format,
    const Streams& streams);

}  // namespace jw
