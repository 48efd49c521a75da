#pragma once

#include <cstdlib>

namespace jw::test {

/// Number in a variable of the environment, for tests that can do more than their share: loops, seeds.
inline unsigned number_from(const char* name, unsigned otherwise) {
    const char* const text = std::getenv(name);
    return text == nullptr ? otherwise : static_cast<unsigned>(std::strtoul(text, nullptr, 10));
}

}  // namespace jw::test
