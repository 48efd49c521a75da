#pragma once

#include <string>

#include "core/model/mechanism.hpp"

namespace jw::snapshot {

/// Name of the thing that a part of the scene belongs to, by the part's id: "crank", "hinge", "hinge s_i";
/// "ground and paths" for 0.
std::string name_of_part(int id, const Mechanism& mechanism);

}  // namespace jw::snapshot
