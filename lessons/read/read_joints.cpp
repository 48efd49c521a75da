#include <algorithm>

#include "lessons/lesson/things.hpp"
#include "lessons/read/reading.hpp"

namespace jw::reading {

namespace {

/// Checks the keys of a joint whose type is not known: each of them can still be wrong by itself.
void check_keys(Fields& fields) {
    for (const char* key : {"at", "to", "point_i", "point_j"}) { fields.vector(key); }
    for (const char* key : {"axis", "axis2", "axis_i", "axis_j", "side", "side_i", "side_j"}) {
        fields.direction(key);
    }
    for (const char* key : {"pitch", "advance_per_rad", "radius", "ratio", "d_0"}) { fields.number(key); }
    fields.positive("length");
    fields.numbers("radii");
    fields.raw("curve");
    fields.formula("formula");
    for (const char* key : {"theta_0", "theta", "angle"}) { fields.angle(key); }
    for (const char* key :
         {"theta_dot_rad_per_s", "theta_dot_deg_per_s", "angle_dot_rad_per_s", "angle_dot_deg_per_s",
          "displacement", "displacement_dot"}) {
        fields.number(key);
    }
    for (const char* key : {"angle_row", "parallel"}) { fields.text(key); }
    fields.texts("without");
}

void read_parallel_form(Fields& fields, Joint& joint) {
    if (!std::ranges::any_of(joint.type->roles, is_parallel)) { return; }
    joint.parallel_form = fields.word("parallel", kParallelForms).value_or(joint.parallel_form);
}

/// Equations that are taken out, by the names that the program shows beside their rows.
void read_without(Fields& fields, Joint& joint) {
    const auto names = fields.texts("without");
    if (!names) { return; }
    const std::vector<LabelledEquation> all = equations_of(*joint.type, joint.parallel_form);
    for (const Located<std::string>& name : names->value) {
        const std::string label = name.value == "theta" ? "θ" : name.value;
        const auto found = std::ranges::find(all, label, &LabelledEquation::label);
        if (found == all.end()) {
            std::vector<std::string> labels;
            for (const LabelledEquation& one : all) { labels.push_back(one.label); }
            fields.report(
                Code::unknown_equation, name.span,
                "a " + std::string(joint.type->name) + " joint has no equation " + in_quotes(name.value) +
                    "; expected one of " + comma_list(labels),
                did_you_mean(name.value, labels));
        } else if (std::ranges::find(joint.without, found->equation) != joint.without.end()) {
            fields.report(
                Code::named_twice, name.span,
                in_quotes(name.value) + " is in 'without' twice; expected each equation once");
        } else {
            joint.without.push_back(found->equation);
        }
    }
}

void read_joint(Fields& fields, Reading& reading) {
    const int errors = reading.problems->errors_count();
    std::vector<Joint>& joints = reading.lesson.mechanism.joints;
    const int index = static_cast<int>(joints.size());
    Joint joint;
    joint.name = reading.declare(fields, Named::Kind::joint, index);
    const auto type = fields.word("type");
    fields.require("type", "one of " + comma_list(words_in<kJointTypes>()));
    const PairIndices bodies = read_pair(fields, reading);
    joint.body_i = bodies.i;
    joint.body_j = bodies.j;
    joint.type = &kJointTypes[type.value_or(0)];
    const auto words = fields.words("text");
    if (type) {
        read_geometry(fields, pair_of(reading, bodies), joint);
        read_start_values(fields, joint, index, reading);
        read_parallel_form(fields, joint);
        read_without(fields, joint);
        if (!joint.name.empty()) {
            fields.call(std::string(joint.type->name) + " joint " + in_quotes(joint.name));
        }
    } else {
        check_keys(fields);
    }
    fields.finish();
    if (reading.problems->errors_count() > errors) { reading.distrust(joint.name); }
    reading.lesson.order.push_back({Addition::Kind::joint, index});
    reading.lesson.step_texts.joints.push_back(words ? words->value : Text());
    joints.push_back(std::move(joint));
}

}  // namespace

std::string types_with(bool (JointType::*has)() const) {
    std::vector<std::string> names;
    for (const JointType& type : kJointTypes) {
        if ((type.*has)()) { names.emplace_back(type.name); }
    }
    return comma_list(names);
}

PairIndices read_pair(Fields& fields, const Reading& reading) {
    const auto names = fields.texts("bodies");
    fields.require("bodies", "two names of bodies");
    if (!names) { return {}; }
    Problems& problems = fields.problems();
    if (names->value.size() != 2) {
        problems.add(
            Code::wrong_count, names->span,
            "'bodies' has " + std::to_string(names->value.size()) +
                (names->value.size() == 1 ? " entry" : " entries") + "; expected two names");
        return {};
    }
    const Located<std::string>& second = names->value[1];
    const Named* i = reading.body(names->value[0]);
    const Named* j = reading.body(second);
    if (i == nullptr || j == nullptr) { return {}; }
    const PairIndices pair{i->index, j->index, i->sound && j->sound};
    if (pair.i == pair.j) {
        problems.add(
            Code::same_body, second.span,
            "both bodies are " + in_quotes(second.value) + "; expected two different ones");
        return {};
    }
    const auto& bodies = reading.lesson.mechanism.bodies;
    if (bodies[jw::at(pair.i)].fixed && bodies[jw::at(pair.j)].fixed) {
        problems.add(
            Code::fixed_body, names->span, "both bodies are fixed; expected at least one that moves");
    }
    return pair;
}

BodyPair pair_of(const Reading& reading, const PairIndices& indices) {
    const auto& bodies = reading.lesson.mechanism.bodies;
    return {&bodies[jw::at(indices.i)], &bodies[jw::at(indices.j)], indices.sound};
}

void read_joints(Fields& root, Reading& reading) {
    std::vector<Fields> joints = root.tables("joint", kMostJoints);
    for (Fields& fields : joints) { read_joint(fields, reading); }
    if (reading.problems->errors_count() > 0) { return; }
    std::vector<Fields> bodies = root.tables("body", kMostBodies);
    take_as_meant(bodies, joints, reading);
}

}  // namespace jw::reading
