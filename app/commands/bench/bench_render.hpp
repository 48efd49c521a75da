#pragma once

#include <string>
#include <vector>

#include "app/commands/options/size_option.hpp"
#include "app/commands/program/command.hpp"

namespace jw {

/// `jointwise bench --render`: the cost of a picture of the motion, stage by stage, beside a plain loop that
/// only draws, reads back and writes with stb_image_write.
/// @throws CommandError for a file that is not a lesson, or has no motion
Exit bench_render(
    const std::vector<std::string>& scenes, const PixelSize& size, const std::string& format,
    const Streams& streams);

}  // namespace jw
