#pragma once

#include <string>

#include "app/session/picture/picture.hpp"

namespace jw::test {

/// Every number of a picture, bit by bit, and its names.
std::string values_of(const Picture& picture);

}  // namespace jw::test
