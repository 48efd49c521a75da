#include "lessons/lesson/equation_labels.hpp"

namespace jw {

namespace {

int equations_count(Role role, ParallelForm form) {
    const Primitive primitive = primitive_of(role, JointGeometry{}, form);
    return std::visit([](const auto& p) { return p.kEquations; }, primitive);
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

}  // namespace jw
