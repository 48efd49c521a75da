#include "lessons/lesson/things.hpp"

#include <algorithm>
#include <array>

#include "lessons/lesson/lesson.hpp"
#include "lessons/lesson/questions.hpp"

namespace jw {

namespace {

int equations_count(Role role, ParallelForm form) {
    const Primitive primitive = primitive_of(role, JointGeometry{}, form);
    return std::visit([](const auto& p) { return p.kEquations; }, primitive);
}

/// A vector of a joint: its name, and the vectors of primitives and of formulas that it stands for.
struct PointedVector {
    const char* name;
    unsigned of_primitives;
    std::array<FormulaVector, 2> of_formulas;
};
// by Thing::kVectorI, kVectorJ, kVectorD
constexpr std::array kParts{
    PointedVector{"s_i", kPoints | kAxisI | kSidesH | kSidesU, {FormulaVector::s_i, FormulaVector::u_i}},
    PointedVector{"s_j", kPoints | kAxisJ | kSidesH | kSidesU, {FormulaVector::s_j, FormulaVector::u_j}},
    PointedVector{"d", kD, {FormulaVector::d, FormulaVector::d}}};

int count_of(std::size_t size) { return static_cast<int>(size); }

void add_vectors(const Joint& joint, int index, std::vector<Thing>& things) {
    for (const int part : {Thing::kVectorI, Thing::kVectorJ, Thing::kVectorD}) {
        const auto has = [&](Role role) { return is_made_of(joint, role, part); };
        if (std::ranges::any_of(joint.type->roles, has)) { things.push_back(Thing::vector(index, part)); }
    }
}

std::string label_of(const Joint& joint, const EquationOut& equation) {
    for (const LabelledEquation& labelled : equations_of(*joint.type, joint.parallel_form)) {
        if (labelled.equation == equation) { return labelled.label; }
    }
    // the form has changed: the joint does not have this equation any more
    return {};
}

/// The words of a name with one blank between them.
std::string trimmed(std::string_view name) {
    std::string kept;
    for (const char c : name) {
        const bool blank = c == ' ' || c == '\t';
        if (!blank || (!kept.empty() && kept.back() != ' ')) { kept += blank ? ' ' : c; }
    }
    if (!kept.empty() && kept.back() == ' ') { kept.pop_back(); }
    return kept;
}

}  // namespace

std::string primitive_name(Role role, ParallelForm form) {
    const RoleTraits& traits = traits_of(role);
    const bool as_pair = form == ParallelForm::pair && !traits.pair_name.empty();
    return std::string(as_pair ? traits.pair_name : traits.name);
}

std::string component_name(int equations, int component) {
    if (equations == 1) { return {}; }
    const char* names = equations == 2 ? "ab" : "xyz";
    return {names[component]};
}

std::vector<LabelledEquation> equations_of(const JointType& type, ParallelForm form) {
    std::vector<LabelledEquation> all;
    for (const Role role : type.roles) {
        const int count = equations_count(role, form);
        for (int k = 0; k < count; ++k) {
            const std::string component = component_name(count, k);
            all.push_back(
                {primitive_name(role, form) + (component.empty() ? "" : " ") + component, {role, k}});
        }
    }
    return all;
}

bool contains_any(const ScalarFormula& formula, std::initializer_list<FormulaVector> vectors) {
    return std::ranges::any_of(vectors, [&](FormulaVector vector) {
        const int first = variable_of(vector, 0);
        return formula.uses_any(first, first + 3);
    });
}

bool is_made_of(const Joint& joint, Role role, int part) {
    const auto& [name, of_primitives, of_formulas] = kParts[jw::at(part)];
    if (role != Role::formula) { return (traits_of(role).vectors & of_primitives) != 0; }
    return contains_any(joint.geometry.formula, {of_formulas[0], of_formulas[1]});
}

std::vector<Thing> things_of(const Mechanism& mechanism, Thing::Kind kind) {
    std::vector<Thing> things;
    if (kind == Thing::Kind::body) {
        for (int b = 0; b < count_of(mechanism.bodies.size()); ++b) { things.push_back(Thing::body(b)); }
        return things;
    }
    for (int k = 0; k < count_of(mechanism.joints.size()); ++k) {
        const Joint& joint = mechanism.joints[jw::at(k)];
        if (kind == Thing::Kind::joint) { things.push_back(Thing::joint(k)); }
        if (joint.type == nullptr) { continue; }
        if (kind == Thing::Kind::vector) { add_vectors(joint, k, things); }
        if (kind != Thing::Kind::row) { continue; }
        for (const LabelledEquation& labelled : equations_of(*joint.type, joint.parallel_form)) {
            things.push_back(Thing::row(k, labelled.equation));
        }
    }
    for (int d = 0; kind == Thing::Kind::row && d < count_of(mechanism.drivers.size()); ++d) {
        things.push_back(Thing::row_of_driver(d));
    }
    return things;
}

std::string name_of(const Thing& thing, const Mechanism& mechanism) {
    const auto k = static_cast<std::size_t>(thing.index);
    switch (thing.kind) {
        case Thing::Kind::body: return mechanism.bodies[k].name;
        case Thing::Kind::joint: return mechanism.joints[k].name;
        case Thing::Kind::vector: return mechanism.joints[k].name + " " + kParts[jw::at(thing.part)].name;
        case Thing::Kind::row: break;
    }
    if (thing.driven) { return mechanism.drivers[k].name; }
    return mechanism.joints[k].name + " " + label_of(mechanism.joints[k], thing.equation);
}

std::optional<Thing> thing_named(const Mechanism& mechanism, Thing::Kind kind, std::string_view name) {
    const std::string wanted = trimmed(name);
    for (const Thing& thing : things_of(mechanism, kind)) {
        if (trimmed(name_of(thing, mechanism)) == wanted) { return thing; }
    }
    return std::nullopt;
}

bool is_present(const Thing& thing, const Lesson& lesson) {
    if (thing.kind == Thing::Kind::body) { return true; }
    if (thing.kind == Thing::Kind::row && thing.driven) {
        return is_added({Addition::Kind::driver, thing.index}, lesson);
    }
    const Joint& joint = lesson.mechanism.joints[jw::at(thing.index)];
    const bool has_row = thing.kind != Thing::Kind::row || !label_of(joint, thing.equation).empty();
    return has_row && is_added({Addition::Kind::joint, thing.index}, lesson);
}

}  // namespace jw
