#pragma once

#include <string>
#include <vector>

#include "app/commands/command.hpp"

namespace jw {

/// The program `jointwise`.
/// @param arguments without the program's name
/// @return the exit status
int run_program(const std::vector<std::string>& arguments, const Streams& streams);

}  // namespace jw
