#pragma once

#include <vector>

#include "core/equations/system.hpp"

/// Numbers of joints that are known only to their last digit, and the effect of changing them.
namespace jw {

/// A number that is known to half a unit of its last digit.
struct TypedNumber {
    /// Change of a vector, or of a scalar instead, of a joint's geometry per unit of the number.
    struct Change {
        int joint = 0;
        Vec3 JointGeometry::*vector = nullptr;
        Vec3 direction = Vec3::Zero();
        double JointGeometry::*scalar = nullptr;

        bool is_length() const;
    };
    double half_unit = 0.0;
    std::vector<Change> changes;
    /// True if the number has few digits: it counts as rounded only if nothing else explains the misfit.
    bool is_short = false;
    int index = 0;  ///< in the list of all numbers
};

/// Joints with the numbers changed by `changes`, each in half units; axes keep their lengths.
std::vector<Joint> changed_joints(
    const std::vector<Joint>& joints, const std::vector<TypedNumber>& numbers, const VectorX& changes);

/// Change of the scaled rows of a system of joints per half unit of a number.
VectorX derivative(const System& system, const State& state, const TypedNumber& number);

}  // namespace jw
