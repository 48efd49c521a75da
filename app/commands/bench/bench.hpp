#pragma once

#include <string>
#include <vector>

#include "app/commands/options/shared_options.hpp"
#include "app/commands/program/command.hpp"

/// The parts of `jointwise bench` that measure something other than dynamics.
namespace jw {

/// `jointwise bench --kinematics`: lessons by file or name; by default all shipped lessons that drivers move.
/// @throws CommandError for a lesson without a driven motion
Exit bench_kinematics(
    const std::vector<std::string>& scenes, const std::string& format, const Streams& streams);

/// `jointwise bench --render`: the cost of a picture of the motion, stage by stage, beside a plain loop that
/// only draws, reads back and writes with stb_image_write.
/// @throws CommandError for a file that is not a lesson, or has no motion
Exit bench_render(
    const std::vector<std::string>& scenes, const PixelSize& size, const std::string& format,
    const Streams& streams);

}  // namespace jw
