#include "core/poses/typed/typed_number.hpp"

#include <algorithm>

namespace jw {

namespace {

constexpr double kDifference = 1e-5;

void add(JointGeometry& geometry, const TypedNumber::Change& change, double by) {
    if (change.scalar != nullptr) {
        geometry.*change.scalar += by;
    } else {
        geometry.*change.vector += by * change.direction;
    }
}

JointGeometry changed(const Mechanism& mechanism, int joint, const TypedNumber& number, double by) {
    JointGeometry geometry = mechanism.joints[at(joint)].geometry;
    for (const TypedNumber::Change& change : number.changes) {
        if (change.joint == joint) { add(geometry, change, by); }
    }
    return geometry;
}

}  // namespace

bool TypedNumber::Change::is_length() const {
    return scalar != nullptr || vector == &JointGeometry::P_i_local || vector == &JointGeometry::P_j_local;
}

std::vector<Joint> changed_joints(
    const std::vector<Joint>& joints, const std::vector<TypedNumber>& numbers, const VectorX& changes) {
    std::vector<Joint> out = joints;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        const double by = changes(static_cast<Eigen::Index>(k)) * numbers[k].half_unit;
        for (const TypedNumber::Change& change : numbers[k].changes) {
            add(out[at(change.joint)].geometry, change, by);
        }
    }
    for (std::size_t j = 0; j < joints.size(); ++j) {
        for (Vec3 JointGeometry::*axis : {&JointGeometry::s_i_local, &JointGeometry::s_j_local}) {
            const double length = (joints[j].geometry.*axis).norm();
            (out[j].geometry.*axis) *= length / (out[j].geometry.*axis).norm();
        }
    }
    return out;
}

VectorX derivative(const System& system, const State& state, const TypedNumber& number) {
    VectorX out = VectorX::Zero(system.rows());
    const Mechanism& mechanism = system.mechanism();
    for (const Constraint& c : system.constraints()) {
        if (std::ranges::find(number.changes, c.joint, &TypedNumber::Change::joint) == number.changes.end()) {
            continue;
        }
        const auto values = [&](double by) {
            Constraint moved = c;
            moved.primitive = primitive_of(
                c.role, changed(mechanism, c.joint, number, by), mechanism.joints[at(c.joint)].parallel_form);
            return values_of(moved, state);
        };
        // equations are at most quadratic in a number: the difference is exact up to rounding
        const VectorX change =
            (values(kDifference) - values(-kDifference)) * (number.half_unit / (2.0 * kDifference * c.unit));
        int row = c.first_row;
        for (int k = 0; k < c.equations; ++k) {
            if (c.has_row(k)) { out(row++) = change(k); }
        }
    }
    return out;
}

}  // namespace jw
