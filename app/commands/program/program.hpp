#pragma once

#include <string>
#include <vector>

#include "app/commands/program/command.hpp"
#include "app/commands/program/surface.hpp"

namespace jw {

/// The program `jointwise`.
/// @param arguments without the program's name
/// @param doctor_window  looks at the window's surface for `doctor`; empty where there is none
/// @return the exit status
int run_program(
    const std::vector<std::string>& arguments, const Streams& streams,
    const SurfaceDoctor& doctor_window = {});

}  // namespace jw
