#pragma once

/// As app.hpp, for commands: the parser of the command line is most of the code that each of them compiles.
#include <CLI/CLI.hpp>

#include "cmake/precompiled/app.hpp"
