#include <algorithm>
#include <array>

#include "app/session/try/experiment_parts.hpp"
#include "lessons/formula/steps_of_formula.hpp"
#include "lessons/lesson/enum_words.hpp"
#include "lessons/typed/exact_text.hpp"

namespace jw::experiment_text {

namespace {

struct VectorKey {
    const char* name;
    Vec3 JointGeometry::*member;
};
constexpr std::array kVectors{
    VectorKey{"s_i", &JointGeometry::s_i_local}, VectorKey{"s_j", &JointGeometry::s_j_local},
    VectorKey{"P_i", &JointGeometry::P_i_local}, VectorKey{"P_j", &JointGeometry::P_j_local},
    VectorKey{"h_i", &JointGeometry::h_i_local}, VectorKey{"h_j", &JointGeometry::h_j_local},
    VectorKey{"u_i", &JointGeometry::u_i_local}, VectorKey{"u_j", &JointGeometry::u_j_local}};

struct NumberKey {
    const char* name;
    double JointGeometry::*member;
};
constexpr std::array kNumbers{
    NumberKey{"length", &JointGeometry::length}, NumberKey{"alpha", &JointGeometry::alpha},
    NumberKey{"d_0", &JointGeometry::d_0}, NumberKey{"theta_0", &JointGeometry::theta_0},
    NumberKey{"ratio", &JointGeometry::ratio}};

struct OptionalKey {
    const char* name;
    std::optional<double> JointGeometry::*member;
};
constexpr std::array kOptional{
    OptionalKey{"theta_start", &JointGeometry::theta_start},
    OptionalKey{"theta_dot_start", &JointGeometry::theta_dot_start},
    OptionalKey{"angle_dot_start", &JointGeometry::angle_dot_start},
    OptionalKey{"displacement_dot_start", &JointGeometry::displacement_dot_start}};

constexpr const char* kAngleRow = "angle_row";
constexpr const char* kFormula = "formula";

std::vector<std::string> keys() {
    std::vector<std::string> all;
    for (const VectorKey& key : kVectors) { all.emplace_back(key.name); }
    for (const NumberKey& key : kNumbers) { all.emplace_back(key.name); }
    for (const OptionalKey& key : kOptional) { all.emplace_back(key.name); }
    all.emplace_back(kAngleRow);
    all.emplace_back(kFormula);
    return all;
}

const Joint& joint_of(const Lesson& lesson, int index) {
    return lesson.mechanism.joints.at(static_cast<std::size_t>(index));
}

SetGeometry joint_named(Words& words, const Lesson& lesson) {
    const auto index = static_cast<int>(words.name(names_of_joints(lesson), "joint"));
    return {index, joint_of(lesson, index).geometry};
}

bool side_of(Words& words) {
    static const std::vector<std::string> sides{"i", "j"};
    return words.name(sides, "side") == 1;
}

ScalarFormula read_formula(Words& words, const JointType& type) {
    if (!type.has_formula()) { throw Unreadable("a " + std::string(type.name) + " joint has no formula"); }
    try {
        return formula::constraint_formula(words.text("the formula"));
    } catch (const formula::NotEvaluated& failed) {
        throw Unreadable(failed.problem().message, failed.problem().hint);
    }
}

void read_member(Words& words, const JointType& type, JointGeometry& g) {
    const std::vector<std::string> all = keys();
    const std::string key = all[words.name(all, "part of a joint")];
    for (const VectorKey& k : kVectors) {
        if (key == k.name) { g.*k.member = words.vector(key); }
    }
    for (const NumberKey& k : kNumbers) {
        if (key != k.name) { continue; }
        g.*k.member = words.number(key);
        if (k.member == &JointGeometry::ratio) { g.radii = {}; }
    }
    for (const OptionalKey& k : kOptional) {
        if (key != k.name) { continue; }
        g.*k.member = words.take("none") ? std::nullopt : std::optional<double>(words.number(key));
    }
    if (key == kAngleRow) {
        g.screw_angle_form = kAngleRows[words.name(words_of(kAngleRows), "angle row")].value;
    }
    if (key == kFormula) { g.formula = read_formula(words, type); }
}

/// The members in which `g` differs from `before`, as words.
std::string differences(const JointGeometry& before, const JointGeometry& g) {
    std::string text;
    const auto add = [&](const char* key, const std::string& value) {
        text += " " + std::string(key) + " " + value;
    };
    for (const VectorKey& k : kVectors) {
        if (before.*k.member != g.*k.member) { add(k.name, numbers_text(g.*k.member)); }
    }
    for (const NumberKey& k : kNumbers) {
        if (before.*k.member != g.*k.member) { add(k.name, writing::number_text(g.*k.member)); }
    }
    for (const OptionalKey& k : kOptional) {
        const std::optional<double>& value = g.*k.member;
        if (before.*k.member != value) { add(k.name, value ? writing::number_text(*value) : "none"); }
    }
    if (before.screw_angle_form != g.screw_angle_form) {
        add(kAngleRow, word_of(kAngleRows, g.screw_angle_form));
    }
    if (before.formula != g.formula) { add(kFormula, "\"" + g.formula.source + "\""); }
    return text;
}

}  // namespace

std::string numbers_text(const Vec3& v) {
    return writing::number_text(v.x()) + " " + writing::number_text(v.y()) + " " +
           writing::number_text(v.z());
}

SetGeometry read_axis(Words& words, const Lesson& lesson) {
    SetGeometry experiment = joint_named(words, lesson);
    const bool in_body_j = side_of(words);
    const Vec3 direction = words.vector("a direction");
    if (direction.norm() < 1e-9) { throw Unreadable("the axis has length 0; expected a direction"); }
    experiment.geometry = with_axis(experiment.geometry, in_body_j, direction);
    return experiment;
}

SetGeometry read_point(Words& words, const Lesson& lesson) {
    SetGeometry experiment = joint_named(words, lesson);
    Vec3 JointGeometry::*const point = side_of(words) ? &JointGeometry::P_j_local : &JointGeometry::P_i_local;
    experiment.geometry.*point = words.vector("a coordinate [m]");
    return experiment;
}

SetGeometry read_length(Words& words, const Lesson& lesson) {
    SetGeometry experiment = joint_named(words, lesson);
    const Joint& joint = joint_of(lesson, experiment.joint);
    if (!joint.type->uses(Role::length)) {
        throw Unreadable("a " + std::string(joint.type->name) + " joint has no length");
    }
    experiment.geometry.length = words.number("a length [m]");
    words.take("m");
    if (experiment.geometry.length <= 0.0) { throw Unreadable("a length must be above 0"); }
    return experiment;
}

SetGeometry read_geometry(Words& words, const Lesson& lesson) {
    SetGeometry experiment = joint_named(words, lesson);
    const JointType& type = *joint_of(lesson, experiment.joint).type;
    while (!words.done()) { read_member(words, type, experiment.geometry); }
    return experiment;
}

std::string text_of(const SetGeometry& experiment, const Lesson& lesson) {
    const Joint& joint = joint_of(lesson, experiment.joint);
    const std::string name = quoted_name(joint.name, names_of_joints(lesson));
    const JointGeometry& g = experiment.geometry;
    for (const bool in_body_j : {false, true}) {
        const std::string side = in_body_j ? " j " : " i ";
        const Vec3& s = in_body_j ? g.s_j_local : g.s_i_local;
        if (s != (in_body_j ? joint.geometry.s_j_local : joint.geometry.s_i_local) && s.norm() > 0.0 &&
            with_axis(joint.geometry, in_body_j, s) == g) {
            return "axis " + name + side + numbers_text(s);
        }
        JointGeometry moved = joint.geometry;
        (in_body_j ? moved.P_j_local : moved.P_i_local) = in_body_j ? g.P_j_local : g.P_i_local;
        if (moved == g && moved != joint.geometry) {
            return "point " + name + side + numbers_text(in_body_j ? g.P_j_local : g.P_i_local);
        }
    }
    return "geometry " + name + differences(joint.geometry, g);
}

}  // namespace jw::experiment_text
