#pragma once

#include <optional>

#include "lessons/formula/body_values.hpp"

/// Symbols of a joint at an instant: its vectors, Φ, blocks of Φq, γ.
namespace jw::formula {

/// @param role  primitive whose Φ is meant; nothing: all primitives of the joint
std::optional<Value> value_of_joint_symbol(
    const Instant& instant, int joint, std::optional<Role> role, const Symbol& symbol);

}  // namespace jw::formula
