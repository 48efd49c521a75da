#pragma once

#include <string>
#include <vector>

#include "app/commands/program/command.hpp"

namespace jw {

/// `jointwise bench --kinematics`: lessons by file or name; by default all shipped lessons that drivers move.
/// @throws CommandError for a lesson without a driven motion
Exit bench_kinematics(
    const std::vector<std::string>& scenes, const std::string& format, const Streams& streams);

}  // namespace jw
