#pragma once

#include <string>

namespace CLI {
class App;
class Error;
}  // namespace CLI

namespace jw {

/// A mistake in the command line in the words of this program: what is wrong, what was expected. The parser's
/// own words name types and counts.
/// @param command  that was meant, or the program where the line did not get that far
std::string usage_fault(const CLI::App& command, const CLI::Error& error);

/// Error in numbers that the parser takes for right, an empty one or 010 for 8; empty if there is
/// none. To be called after parsing.
std::string fault_of_numbers(const CLI::App& command);

}  // namespace jw
