#pragma once

/// Headers that most sources read, compiled once for each set of flags (cmake/precompiled.cmake). Each source
/// still includes all headers that it uses; `./dev tidy` builds without precompiled headers.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <numeric>
#include <optional>
#include <ranges>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/eigen/decompositions.hpp"
#include "core/equations/system.hpp"
