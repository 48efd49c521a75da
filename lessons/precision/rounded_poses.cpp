#include <algorithm>
#include <array>

#include "core/jets/euler_parameters.hpp"
#include "lessons/precision/rounded_numbers.hpp"

/// Numbers of the poses of bodies. When a pose changes, vectors typed in the global frame stay, and vectors
/// typed in the frame of the body follow it. Instead, poses are kept here, and the local vectors change by
/// the same amount.
namespace jw::reading {

namespace {

// relative step of an axis in a central difference, which is exact to 1e-10
constexpr double kDifference = 1e-5;

/// Turn of a body [rad, local] that a small `change` of its p causes.
Vec3 turn_of(const Vec4& p, const Vec4& change) { return 2.0 * L_of(p.normalized()) * change / p.norm(); }

}  // namespace

std::vector<RoundedNumbers::Change> RoundedNumbers::moved(
    const Body& body, const std::vector<LocalVectors>& locals, const Displacement& by) const {
    const Vec3 shift = rotation_of(body).transpose() * by.shift;
    std::vector<Change> changes;
    for (const LocalVectors& local : locals) {
        const JointGeometry& g = reading_.lesson.mechanism.joints[at(local.joint)].geometry;
        for (Vec3 JointGeometry::*vector : local.vectors) {
            const bool is_point = vector == &JointGeometry::P_i_local || vector == &JointGeometry::P_j_local;
            const Vec3 turned = by.turn_local.cross(g.*vector);
            const Vec3 direction = is_point ? Vec3(turned + shift) : turned;
            if (!direction.isZero(0.0)) { changes.push_back({local.joint, vector, direction}); }
        }
    }
    return changes;
}

/// Adds the numbers of `axes`. The reader normalises them, keeps x, and turns y in their plane.
void RoundedNumbers::add_frame(
    Fields& axes, const std::string& what, const Body& body, const std::vector<LocalVectors>& locals) {
    const Mat3 A = rotation_of(body);
    for (int column = 0; column < 3; ++column) {
        const char* key = std::array{"x", "y", "z"}[at(column)];
        const auto changes = [&](Eigen::Index k) {
            std::array<Vec3, 3> d{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
            d[at(column)] = Vec3::Unit(k) / axes.direction(key)->value.norm();
            const bool has_x = axes.has("x");
            const bool has_y = axes.has("y");
            if (!has_x) { d[0] = d[1].cross(A.col(2)) + A.col(1).cross(d[2]); }
            if (!has_y) { d[1] = d[2].cross(A.col(0)) + A.col(2).cross(d[0]); }
            const Vec3 turn(d[1].dot(A.col(2)), -d[0].dot(A.col(2)), d[0].dot(A.col(1)));
            return moved(body, locals, {Vec3::Zero(), turn});
        };
        add(axes, what, key, 3, changes);
    }
}

void RoundedNumbers::add_pose(Fields& fields, int index, const std::vector<LocalVectors>& locals) {
    const Body& body = reading_.lesson.mechanism.bodies[at(index)];
    const std::string what = "body " + in_quotes(body.name);
    const auto turned = [&](const Vec3& turn) { return moved(body, locals, {Vec3::Zero(), turn}); };
    add(fields, what, "position", 3, [&](Eigen::Index k) {
        return moved(body, locals, {Vec3::Unit(k), Vec3::Zero()});
    });
    add(fields, what, "p", 4, [&](Eigen::Index k) { return turned(turn_of(body.p, Vec4::Unit(k))); });
    if (auto axes = fields.table("axes")) { add_frame(*axes, what, body, locals); }
    auto rotation = fields.table("rotation");
    if (!rotation) { return; }
    const Vec3 axis = rotation->direction("axis")->value;
    const double angle = rotation->angle("angle")->value;
    add(*rotation, what, "axis", 3, [&](Eigen::Index k) {
        const Vec3 by = kDifference * axis.norm() * Vec3::Unit(k);
        const Vec4 change = euler_parameters_of(axis + by, angle) - euler_parameters_of(axis - by, angle);
        return turned(turn_of(body.p, change / (2.0 * by.norm())));
    });
    const auto about_axis = [&](Eigen::Index) { return turned(axis.normalized()); };
    add(*rotation, what, "angle_rad", 1, about_axis);
    add(*rotation, what, "angle_deg", 1, about_axis, radians(1.0));
}

void RoundedNumbers::add_poses(std::vector<Fields>& bodies, const std::vector<Fields>& joints) {
    const Mechanism& mechanism = reading_.lesson.mechanism;
    std::vector<std::vector<LocalVectors>> locals(mechanism.bodies.size());
    // a body whose vectors are all local moves with them: its pose changes only the h of joints whose sides
    // are not typed. Lengths of distance joints and d_0 and theta_0 of screws also come from the start pose;
    // they are taken as they are
    std::vector<bool> matters(mechanism.bodies.size(), false);
    for (std::size_t j = 0; j < joints.size(); ++j) {
        const Joint& joint = mechanism.joints[j];
        const std::array pair{at(joint.body_i), at(joint.body_j)};
        for (const std::size_t body : pair) { locals[body].push_back({static_cast<int>(j), {}}); }
        for (const LocalKey& local : kLocalKeys) {
            const bool is_typed = !joints[j].typed_numbers(local.key).empty();
            if (is_typed) { locals[pair[at(local.side)]].back().vectors.push_back(local.vector); }
        }
        for (const char* key : {"at", "axis", "side"}) {
            if (!joints[j].typed_numbers(key).empty()) { matters[pair[0]] = matters[pair[1]] = true; }
        }
        const bool has_default_h = joint.type->uses(kSidesH) && joints[j].typed_numbers("side_i").empty();
        if (has_default_h) { matters[pair[0]] = matters[pair[1]] = true; }
    }
    const bool has_several_fixed = std::ranges::count(mechanism.bodies, true, &Body::fixed) > 1;
    for (Fields& fields : bodies) {
        const int body = reading_.names.find(fields.text("name")->value)->second.index;
        if (matters[at(body)] || (has_several_fixed && mechanism.bodies[at(body)].fixed)) {
            add_pose(fields, body, locals[at(body)]);
        }
    }
}

}  // namespace jw::reading
