#pragma once

#include <map>
#include <string>

namespace jw::test {

/// English messages of the sources, as `./dev messages` finds them. The key of a message with a count is its
/// singular, the value its plural; of all others both are the same.
std::map<std::string, std::string> messages_of_sources();

}  // namespace jw::test
