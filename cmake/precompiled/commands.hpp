#pragma once

/// As app.hpp, for commands: reading a command line is most of what each of them compiles.
#include <CLI/CLI.hpp>

#include "cmake/precompiled/app.hpp"
