#pragma once

#include <string>

namespace CLI {
class App;
class Error;
}  // namespace CLI

namespace jw {

/// A mistake in the command line in this program's words: what is wrong, and what was expected. The parser's
/// own messages name types and counts.
/// @param command  the command that was meant, or the program if the parser did not get that far
std::string usage_fault(const CLI::App& command, const CLI::Error& error);

/// Error in numbers that the parser accepts, such as an empty one, or 010 for 8; empty if there is none. To
/// be called after parsing.
std::string fault_of_numbers(const CLI::App& command);

}  // namespace jw
