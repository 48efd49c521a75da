#include "tests/soak/ways.hpp"

#include <algorithm>

namespace jw::test {

std::vector<Way> ways() {
    std::vector<Way> out;
    for (const Formulation formulation : {Formulation::joints, Formulation::bodies}) {
        SimulationSettings settings;
        settings.formulation = formulation;
        out.push_back(
            {formulation == Formulation::joints ? "explicit-8 in joints" : "explicit-8 in bodies", settings});
    }
    for (const Method method : {Method::explicit_5, Method::implicit_5, Method::implicit_9}) {
        SimulationSettings settings;
        settings.method = method;
        out.push_back({std::string(entry_of(method).name), settings});
    }
    SimulationSettings dense;
    dense.dense = CoordinateChoice::true_euler_parameters;
    out.push_back({"explicit-8 dense in (r, p)", dense});
    return out;
}

std::vector<double> with_events(const Generated& generated, std::vector<double> times) {
    const auto [first, last] = std::pair(times.front(), times.back());
    const auto add = [&](const TimeFunction& f) {
        std::vector<double> kinks;
        f.append_kinks(kinks);
        for (const double t : kinks) {
            if (t > first && t < last) { times.push_back(t); }
        }
    };
    for (const Driver& driver : generated.mechanism.drivers) { add(driver.function); }
    for (const AppliedForce& force : generated.loads.forces) { add(force.magnitude); }
    for (const AppliedTorque& torque : generated.loads.torques) { add(torque.magnitude); }
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

Recipe without_rows_by_hand(Recipe recipe) {
    const auto let_go = [](int& form) {
        const auto own = static_cast<ParallelForm>(form % 6);
        const bool by_hand =
            own == ParallelForm::drop_x || own == ParallelForm::drop_y || own == ParallelForm::drop_z;
        if (by_hand) { form = static_cast<int>(ParallelForm::rule); }
    };
    for (BodyRecipe& body : recipe.bodies) { let_go(body.form); }
    for (JointRecipe& joint : recipe.joints) { let_go(joint.form); }
    return recipe;
}

bool keeps_rows_by_hand(const Mechanism& mechanism) {
    return std::ranges::any_of(mechanism.joints, [](const Joint& joint) {
        return joint.parallel_form == ParallelForm::drop_x || joint.parallel_form == ParallelForm::drop_y ||
               joint.parallel_form == ParallelForm::drop_z;
    });
}

}  // namespace jw::test
