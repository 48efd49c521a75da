#include <cmath>
#include <cstdio>
#include <numbers>

#include "core/euler_parameters.hpp"
#include "lessons/reading.hpp"

namespace jw::reading {

namespace {

// vectors that must be perpendicular, as typed with six digits (0.006 deg)
constexpr double kPerpendicular = 1e-4;

/// The two bodies of a joint, with what is needed to go from global to local.
struct Pair {
    const Body* i;
    const Body* j;

    Vec3 point_i(const Vec3& global) const { return rotation_of(*i).transpose() * (global - i->r); }
    Vec3 point_j(const Vec3& global) const { return rotation_of(*j).transpose() * (global - j->r); }
    Vec3 vector_i(const Vec3& global) const { return rotation_of(*i).transpose() * global; }
    Vec3 vector_j(const Vec3& global) const { return rotation_of(*j).transpose() * global; }
};

struct Needs {
    bool points = false;
    bool axis_j = false;  ///< a second axis vector in body j
    bool axis = false;
    bool sides = false;
    bool arms = false;  ///< axes are the two arms of n1, perpendicular instead of parallel
};

Needs needs_of(const JointType& type) {
    Needs needs;
    needs.points = type.uses(Role::same_point) || type.uses(Role::distance_parallel) ||
                   type.uses(Role::distance_perpendicular) || type.uses(Role::length);
    needs.arms = type.uses(Role::axes_perpendicular);
    needs.axis_j = type.uses(Role::axes_parallel) || needs.arms;
    needs.axis =
        needs.axis_j || type.uses(Role::distance_parallel) || type.uses(Role::distance_perpendicular);
    needs.sides = type.uses(Role::sides_perpendicular);
    return needs;
}

void read_points(Fields& fields, const Pair& pair, const JointType& type, JointGeometry& g) {
    const bool two_points = type.uses(Role::length);
    const auto at = fields.vector("at");
    const auto point_i = fields.vector("point_i");
    const auto point_j = fields.vector("point_j");
    if (!fields.at_most_one({"at", "point_i"}) || !fields.at_most_one({"at", "point_j"})) { return; }
    if (at) {
        g.P_i_local = pair.point_i(at->value);
        g.P_j_local = pair.point_j(at->value);
        // n2, p2 and a distance join two different points: `to` is the one of body j
        if (const auto to = fields.vector("to")) { g.P_j_local = pair.point_j(to->value); }
        if (two_points && !fields.has("to")) {
            fields.missing("to", "the point of the second body, global, in m");
        }
        return;
    }
    if (point_i) { g.P_i_local = point_i->value; }
    if (point_j) { g.P_j_local = point_j->value; }
    if (!fields.has("at") && !(fields.has("point_i") && fields.has("point_j"))) {
        fields.missing(
            fields.has("point_i") ? "point_j" : (fields.has("point_j") ? "point_i" : "at"),
            "the joint's point: 'at' (global, at the start pose) or 'point_i' and 'point_j' (in the bodies), "
            "in m");
    }
}

void read_axes(Fields& fields, const Pair& pair, const Needs& needs, JointGeometry& g) {
    const auto axis = fields.direction("axis");
    const auto axis_i = fields.direction("axis_i");
    const auto axis_j = fields.direction("axis_j");
    if (!fields.at_most_one({"axis", "axis_i"}) ||
        (needs.axis_j && !fields.at_most_one({"axis", "axis_j"}))) {
        return;
    }
    if (axis) {
        g.s_i_local = pair.vector_i(axis->value.normalized());
        g.s_j_local = pair.vector_j(axis->value.normalized());
    }
    if (axis_i) { g.s_i_local = axis_i->value; }
    if (axis_j) { g.s_j_local = axis_j->value; }
    if (needs.arms) {
        const auto second = fields.direction("axis2");
        if (second) { g.s_j_local = pair.vector_j(second->value.normalized()); }
        if (axis && second) {
            const double cosine = axis->value.normalized().dot(second->value.normalized());
            if (std::abs(cosine) > kPerpendicular) {
                char text[160];
                std::snprintf(
                    text, sizeof text,
                    "'axis' and 'axis2' make an angle of %.4g deg; expected perpendicular arms",
                    std::acos(std::min(1.0, std::max(-1.0, cosine))) * 180.0 / std::numbers::pi);
                fields.problems().add(
                    second->span, text,
                    "give 'axis_i' and 'axis_j' in the bodies for a start that is not assembled");
            }
        }
        if (fields.has("axis") && !fields.has("axis2")) {
            fields.missing("axis2", "the arm of the second body, global, perpendicular to 'axis'");
        }
    }
    const bool local_given = fields.has("axis_i") && (!needs.axis_j || fields.has("axis_j"));
    if (!fields.has("axis") && !local_given) {
        fields.missing(
            fields.has("axis_i") ? "axis_j" : (fields.has("axis_j") ? "axis_i" : "axis"),
            needs.axis_j
                ? "the axis: 'axis' (global, at the start pose) or 'axis_i' and 'axis_j' (in the bodies)"
                : "the axis of the first body: 'axis' (global) or 'axis_i' (in the body)");
    }
}

/// A global side vector made exactly perpendicular to the axis, or a report that it is not.
std::optional<Vec3> checked_side(Fields& fields, const Located<Vec3>& side, const Vec3& axis) {
    const Vec3 s = axis.normalized();
    const double cosine = side.value.normalized().dot(s);
    if (std::abs(cosine) <= kPerpendicular) { return (side.value - side.value.dot(s) * s).normalized(); }
    char text[160];
    std::snprintf(
        text, sizeof text, "the side vector makes an angle of %.4g deg with the axis; expected 90 deg",
        std::acos(std::min(1.0, std::max(-1.0, cosine))) * 180.0 / std::numbers::pi);
    fields.problems().add(side.span, text);
    return std::nullopt;
}

/// u vectors from which the angle about the axis is measured, and the h vectors of n1.
void read_sides(Fields& fields, const Pair& pair, const Needs& needs, JointGeometry& g) {
    const Mat3 A_i = rotation_of(*pair.i);
    const Vec3 axis = A_i * g.s_i_local.normalized();
    // body j's axis turned the shortest way onto that of body i: nothing at an assembled start
    const Vec3 axis_j = rotation_of(*pair.j) * g.s_j_local.normalized();
    const Mat3 onto =
        needs.arms ? Mat3::Identity() : Eigen::Quaterniond::FromTwoVectors(axis_j, axis).toRotationMatrix();

    Vec3 u = perpendicular_to(axis);
    if (const auto side = fields.direction("side")) {
        if (const auto perpendicular = checked_side(fields, *side, axis)) { u = *perpendicular; }
    }
    const Vec3 h_j = axis.cross(u);
    g.u_i_local = pair.vector_i(u);
    g.u_j_local = pair.vector_j(onto.transpose() * u);
    g.h_i_local = g.u_i_local;
    g.h_j_local = pair.vector_j(onto.transpose() * h_j);

    const auto side_i = fields.direction("side_i");
    const auto side_j = fields.direction("side_j");
    if (!fields.at_most_one({"side", "side_i"}) || !fields.at_most_one({"side", "side_j"})) { return; }
    if (side_i.has_value() != side_j.has_value() && fields.has("side_i") != fields.has("side_j")) {
        fields.missing(side_i ? "side_j" : "side_i", "side vectors in both bodies");
        return;
    }
    if (!side_i || !side_j) { return; }
    const auto u_i = checked_side(fields, *side_i, g.s_i_local);
    const auto u_j = checked_side(fields, *side_j, g.s_j_local);
    if (!u_i || !u_j) { return; }
    // h as typed: its length scales the equation; u is a direction
    g.h_i_local = side_i->value;
    g.h_j_local = side_j->value;
    g.u_i_local = *u_i;
    g.u_j_local = *u_j;
}

void read_screw(Fields& fields, const Reading& reading, Joint& joint) {
    JointGeometry& g = joint.geometry;
    if (const auto pitch = fields.number("pitch")) {
        g.alpha = pitch->value / (2.0 * std::numbers::pi);
    } else if (!fields.has("pitch")) {
        fields.missing("pitch", "the advance in one turn [m], negative for a left-hand thread");
    }
    if (const auto form = fields.word("angle_row", {"rotation", "cosine", "sine"})) {
        g.screw_angle_form = static_cast<ScrewAngleForm>(*form);
    }
    // d0 and θ0: the start pose lies on the thread
    Mechanism alone;
    alone.bodies = reading.lesson.mechanism.bodies;
    const Body& i = alone.bodies[static_cast<std::size_t>(joint.body_i)];
    const Body& j = alone.bodies[static_cast<std::size_t>(joint.body_j)];
    const Mat3 A_i = rotation_of(i);
    const Vec3 d = j.r + rotation_of(j) * g.P_j_local - i.r - A_i * g.P_i_local;
    g.d_0 = d.dot(A_i * g.s_i_local.normalized());
    g.theta_0 = relative_angle(joint, start_state(alone));
    if (const auto d_0 = fields.number("d_0")) { g.d_0 = d_0->value; }
    if (const auto theta_0 = fields.angle("theta_0")) { g.theta_0 = theta_0->value; }
}

void read_length(Fields& fields, const Pair& pair, JointGeometry& g) {
    if (const auto length = fields.positive("length")) {
        g.length = length->value;
        return;
    }
    if (fields.has("length")) { return; }
    const Vec3 d =
        pair.j->r + rotation_of(*pair.j) * g.P_j_local - pair.i->r - rotation_of(*pair.i) * g.P_i_local;
    g.length = d.norm();
    if (g.length < 1e-9) {
        fields.problems().add(
            fields.span(), "the two points of the distance coincide; expected a length above 0");
        g.length = 1.0;
    }
}

std::optional<std::pair<int, int>> read_pair(Fields& fields, const Reading& reading) {
    const auto names = fields.texts("bodies");
    if (!names) {
        if (!fields.has("bodies")) { fields.missing("bodies", "two names of bodies"); }
        return std::nullopt;
    }
    if (names->value.size() != 2) {
        fields.problems().add(
            names->span,
            "'bodies' has " + std::to_string(names->value.size()) + " entries; expected two names");
        return std::nullopt;
    }
    const auto i = reading.body(names->value[0]);
    const auto j = reading.body(names->value[1]);
    if (!i || !j) { return std::nullopt; }
    if (*i == *j) {
        fields.problems().add(
            names->value[1].span, "both bodies are the same; expected two different bodies");
        return std::nullopt;
    }
    const auto& bodies = reading.lesson.mechanism.bodies;
    if (bodies[static_cast<std::size_t>(*i)].fixed && bodies[static_cast<std::size_t>(*j)].fixed) {
        fields.problems().add(names->span, "both bodies are fixed; expected at least one that moves");
        return std::nullopt;
    }
    return std::pair(*i, *j);
}

void read_joint(Fields& fields, Reading& reading) {
    Joint joint;
    const auto name = fields.text("name");
    if (!fields.has("name")) { fields.missing("name", "a name for the joint"); }
    if (name) { joint.name = name->value; }
    for (const Joint& other : reading.lesson.mechanism.joints) {
        if (name && other.name == joint.name) {
            reading.problems->add(
                name->span,
                "joint '" + joint.name + "' is there twice; expected a name of its own for each joint");
        }
    }
    std::vector<std::string> types;
    for (const JointType& type : kJointTypes) { types.emplace_back(type.name); }
    const auto type = fields.word("type", types);
    if (!fields.has("type")) { fields.missing("type", "one of " + comma_list(types)); }
    const auto bodies = read_pair(fields, reading);
    std::string words;
    if (const auto text = fields.text("text")) { words = text->value; }
    if (!type || !bodies) { return; }

    joint.type = &kJointTypes[*type];
    joint.body_i = bodies->first;
    joint.body_j = bodies->second;
    const auto& all = reading.lesson.mechanism.bodies;
    const Pair pair{
        &all[static_cast<std::size_t>(joint.body_i)], &all[static_cast<std::size_t>(joint.body_j)]};
    const Needs needs = needs_of(*joint.type);
    if (needs.points) { read_points(fields, pair, *joint.type, joint.geometry); }
    if (needs.axis) {
        read_axes(fields, pair, needs, joint.geometry);
        read_sides(fields, pair, needs, joint.geometry);
    }
    if (joint.type->uses(Role::screw_advance)) { read_screw(fields, reading, joint); }
    if (joint.type->uses(Role::length)) { read_length(fields, pair, joint.geometry); }
    if (joint.type->uses(Role::axes_parallel) || joint.type->uses(Role::distance_parallel)) {
        if (const auto form =
                fields.word("parallel", {"rule", "drop x", "drop y", "drop z", "all three", "pair"})) {
            joint.parallel_form = static_cast<ParallelForm>(*form);
        }
    }
    fields.finish();
    reading.lesson.order.push_back(
        {Addition::Kind::joint, static_cast<int>(reading.lesson.mechanism.joints.size())});
    reading.lesson.mechanism.joints.push_back(joint);
    reading.lesson.step_texts.joints.push_back(words);
}

}  // namespace

void read_joints(Fields& root, Reading& reading) {
    for (Fields& fields : root.tables("joint")) { read_joint(fields, reading); }
}

}  // namespace jw::reading
