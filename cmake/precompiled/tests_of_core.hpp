#pragma once

/// As core.hpp, for tests of core and lessons.
#include <catch2/catch.hpp>

#include "cmake/precompiled/core.hpp"
