#include "lessons/equation_labels.hpp"

namespace jw {

namespace {

int equations_count(Role role, ParallelForm form) {
    const Primitive primitive = primitive_of(role, JointGeometry{}, form);
    return std::visit([](const auto& p) { return p.kEquations; }, primitive);
}

}  // namespace

std::string primitive_name(Role role, ParallelForm form) {
    const bool pair = form == ParallelForm::pair;
    switch (role) {
        case Role::same_point: return "s";
        case Role::axes_parallel: return pair ? "n1 pair" : "p1";
        case Role::distance_parallel: return pair ? "n2 pair" : "p2";
        case Role::axes_perpendicular:
        case Role::sides_perpendicular: return "n1";
        case Role::distance_perpendicular: return "n2";
        case Role::length: return "d";
        case Role::screw_advance: return "r";
        case Role::screw_angle: break;
    }
    return "θ";
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

}  // namespace jw
