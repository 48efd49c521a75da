#pragma once

/// As core.hpp, for code that reads and writes lesson files.
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string_view>

#include "cmake/precompiled/core.hpp"
#include "lessons/fields/fields.hpp"
#include "lessons/lesson/lesson.hpp"
