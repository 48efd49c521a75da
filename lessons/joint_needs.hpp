#pragma once

#include "core/model/joint_types.hpp"

/// Parts of a joint's geometry that a lesson has to give.
namespace jw {

/// Which vectors the primitives of a type use.
struct JointNeeds {
    explicit JointNeeds(const JointType& type)
        : two_points(!type.uses(Role::same_point)),
          points(type.uses(kPoints) || type.uses(kD)),
          arms(type.uses(Role::axes_perpendicular)),
          axis_j(type.uses(kAxisJ)),
          axis(type.uses(kAxisI)),
          sides(type.uses(kSidesH) || type.has_angle()) {}

    bool two_points;  ///< the points of i and j need not coincide
    bool points;
    bool arms;    ///< axes of the two bodies are perpendicular, not parallel
    bool axis_j;  ///< a vector in body j too
    bool axis;
    bool sides;
};

}  // namespace jw
