#pragma once

#include "app/hard/hard_case.hpp"

/// The cases, by the file they are in.
namespace jw::hard {

// kept_pair.cpp
Result kept_pair_at_right_angle();

}  // namespace jw::hard
