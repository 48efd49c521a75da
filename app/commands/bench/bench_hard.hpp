#pragma once

#include <string>
#include <vector>

#include "app/commands/program/command.hpp"

namespace jw {

/// `jointwise bench --hard`: the named cases, or all. Exit status 1 if a number is out of its bounds.
/// @throws CommandError for a name that is not a case
Exit bench_hard(const std::vector<std::string>& names, const std::string& format, const Streams& streams);

}  // namespace jw
