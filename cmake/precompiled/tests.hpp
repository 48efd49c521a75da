#pragma once

/// As app.hpp, for tests of the program.
#include <catch2/catch.hpp>

#include "cmake/precompiled/app.hpp"
