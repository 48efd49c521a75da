#pragma once

#include <optional>
#include <string>

#include "core/jets/coordinates.hpp"
#include "core/model/joint_types.hpp"

/// The tables of slides 20 to 22: the formula of each block of Φq.
namespace jw::formula {

/// A block: the derivative of a primitive by r or by the orientation of body i or j.
struct Block {
    Role role = Role::same_point;
    CoordinateChoice coordinates = CoordinateChoice::omega_local;
    bool of_orientation = false;  ///< else of r
    bool body_i = true;           ///< else of body j
};

/// "\Phi_{\omega'_i}"
std::string block_name(const Block& block);

/// The right side, "\mathbf{s}_j^T (-\tilde{...} ...)"; nothing for primitives without such a formula (those
/// with θ, and formulas of authors), "0" where the primitive does not depend on these coordinates.
std::optional<std::string> block_formula(const Block& block);

}  // namespace jw::formula
