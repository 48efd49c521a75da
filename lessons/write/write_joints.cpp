#include <algorithm>
#include <numbers>

#include "core/model/placement.hpp"
#include "lessons/lesson/enum_words.hpp"
#include "lessons/lesson/things.hpp"
#include "lessons/typed/typed.hpp"
#include "lessons/write/writing.hpp"

namespace jw::writing {

namespace {

// digits of a pitch that somebody typed; with more, it is not easier to read than the advance per radian
constexpr int kPitchDigits = 12;

void write_vectors(const JointType& type, const JointGeometry& g, Lines& lines) {
    const JointNeeds needs(type);
    if (needs.points) {
        lines.key("point_i", g.P_i_local);
        lines.key("point_j", g.P_j_local);
    }
    if (needs.axis) { lines.key("axis_i", g.s_i_local); }
    if (needs.axis_j) { lines.key("axis_j", g.s_j_local); }
    if (needs.sides) {
        const bool angle = type.has_marks();
        lines.key("side_i", angle ? typed_direction(g.u_i_local) : g.h_i_local);
        lines.key("side_j", angle ? typed_direction(g.u_j_local) : g.h_j_local);
    }
}

void write_screw(const JointGeometry& g, Lines& lines) {
    const auto reads_back = [&](double pitch) { return alpha_of_pitch(pitch) == g.alpha; };
    if (const auto pitch = typed_number(2.0 * std::numbers::pi * g.alpha, kPitchDigits, reads_back)) {
        lines.key("pitch", *pitch, "m in one turn");
    } else {
        lines.key("advance_per_rad", g.alpha, "m/rad");
    }
    if (g.screw_angle_form != ScrewAngleForm::rotation) {
        lines.key("angle_row", string_text(word_of(kAngleRows, g.screw_angle_form)));
    }
}

void write_theta(const JointType& type, const JointGeometry& g, Lines& lines) {
    if (type.uses(Role::screw_advance) || type.uses(Role::rack_advance)) {
        lines.key("d_0", g.d_0, "m");
        lines.angle("theta_0", g.theta_0);
    }
    if (g.theta_start) { lines.angle("theta", *g.theta_start); }
    if (g.theta_dot_start) { lines.angle("theta_dot", *g.theta_dot_start, "_per_s"); }
}

void write_start_rates(const JointGeometry& g, Lines& lines) {
    if (g.angle_dot_start) { lines.angle("angle_dot", *g.angle_dot_start, "_per_s"); }
    if (g.displacement_dot_start) { lines.key("displacement_dot", *g.displacement_dot_start, "m/s"); }
}

void write_curve(const Curve& curve, Lines& lines) {
    Inline keys;
    const auto add = [&](const char* key, Vec3 Curve::Harmonic::*part) {
        keys.add(key, list_text(curve.harmonics, [&](const auto& h) { return vector_text(h.*part); }));
    };
    keys.add("constant", curve.constant);
    if (!curve.is_closed()) { keys.add("linear", curve.linear); }
    if (!curve.harmonics.empty()) {
        add("cos", &Curve::Harmonic::cos);
        add("sin", &Curve::Harmonic::sin);
    }
    lines.key("curve", keys.text(), "m");
}

void write_wheels(const JointType& type, const JointGeometry& g, Lines& lines) {
    if (type.has_curve()) {
        write_curve(g.curve, lines);
    } else if (type.uses(Role::rack_advance)) {
        lines.key("radius", g.alpha, "m");
    } else if (g.radii[0] > 0.0) {
        lines.key("radii", list_text(g.radii), "m");
    } else {
        lines.key("ratio", g.ratio);
    }
}

void write_without(const Joint& joint, Lines& lines) {
    const std::vector<LabelledEquation> all = equations_of(*joint.type, joint.parallel_form);
    std::string labels;
    for (const EquationOut& out : joint.without) {
        const auto found = std::ranges::find(all, out, &LabelledEquation::equation);
        if (found != all.end()) { labels += (labels.empty() ? "" : ", ") + string_text(found->label); }
    }
    if (!labels.empty()) { lines.key("without", '[' + labels + ']', "taken out"); }
}

void write_joint(const Written& written, const Joint& joint, const Text& text, Lines& lines) {
    lines.table("[[joint]]");
    lines.key("name", string_text(joint.name));
    lines.key("type", string_text(std::string(joint.type->name)));
    lines.key("bodies", written.pair(joint.body_i, joint.body_j));
    write_vectors(*joint.type, joint.geometry, lines);
    if (joint.type->has_formula()) { lines.key("formula", string_text(joint.geometry.formula.source)); }
    if (joint.type->uses(Role::length)) { lines.key("length", joint.geometry.length, "m"); }
    if (joint.type->uses(Role::screw_advance)) { write_screw(joint.geometry, lines); }
    if (joint.type->has_own_coordinate()) { write_wheels(*joint.type, joint.geometry, lines); }
    if (joint.type->artificial > 0) { write_theta(*joint.type, joint.geometry, lines); }
    write_start_rates(joint.geometry, lines);
    if (joint.parallel_form != ParallelForm::rule && std::ranges::any_of(joint.type->roles, is_parallel)) {
        lines.key("parallel", string_text(word_of(kParallelForms, joint.parallel_form)));
    }
    write_without(joint, lines);
    if (!text.own().empty()) { lines.text("text", text); }
}

}  // namespace

void write_joints(const Written& written, Lines& lines) {
    const std::vector<Joint>& joints = written.lesson->mechanism.joints;
    bool any = false;
    for (std::size_t k = 0; k < joints.size(); ++k) {
        if (!written.has({Addition::Kind::joint, static_cast<int>(k)})) { continue; }
        if (!any) {
            lines.section("joints: points [m] and directions in the frames of their bodies, i and j");
        }
        any = true;
        write_joint(written, joints[k], written.lesson->step_texts.joints[k], lines);
    }
}

}  // namespace jw::writing
