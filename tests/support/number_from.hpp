#pragma once

#include <cstdlib>

namespace jw::test {

/// Number from an environment variable, for tests that can run more than their default: loops, seeds.
inline unsigned number_from(const char* name, unsigned otherwise) {
    const char* const text = std::getenv(name);
    return text == nullptr ? otherwise : static_cast<unsigned>(std::strtoul(text, nullptr, 10));
}

}  // namespace jw::test
