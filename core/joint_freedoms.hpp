#pragma once

#include "core/joint_types.hpp"

/// What a joint leaves free along and about its axis.
namespace jw {

/// The angle about the axis is free: it can be driven or claimed, and sides say from where it is measured.
inline bool has_angle(const JointType& type) {
    return type.uses(Role::axes_parallel) && !type.uses(Role::sides_perpendicular);
}

/// The displacement along the axis is free.
inline bool has_displacement(const JointType& type) { return type.uses(Role::distance_parallel); }

}  // namespace jw
