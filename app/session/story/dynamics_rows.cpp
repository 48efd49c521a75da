#include "app/session/story/dynamics_rows.hpp"

#include "app/session/story/dynamics_run.hpp"
#include "app/session/story/story.hpp"
#include "app/session/story/taking_part.hpp"
#include "core/motion/spring_turns.hpp"
#include "core/numerics/linear.hpp"

namespace jw {

namespace {

/// State and motion of every moving body, and the energies.
std::vector<NamedQuantity> columns_of_run(const Lesson& lesson) {
    std::vector<NamedQuantity> list;
    const std::vector<Body>& bodies = lesson.mechanism.bodies;
    for (int b = 0; b < static_cast<int>(bodies.size()); ++b) {
        if (bodies[at(b)].fixed) { continue; }
        const auto add_places = [&](int derivative, int count) {
            for (int k = 0; k < count; ++k) {
                list.push_back({MeasureQuantity{CoordinateMeasure{k}, 0, b, -1, -1}, derivative});
            }
        };
        add_places(0, 7);
        add_places(1, 3);
        for (int k = 0; k < 3; ++k) { list.push_back({AngularVelocityQuantity{b, true, k}, 0}); }
    }
    list.push_back({EnergyQuantity{EnergyPart::kinetic}, 0});
    list.push_back({EnergyQuantity{EnergyPart::potential}, 0});
    return list;
}

double number_of(const NamedQuantity& named, const Instant& instant) {
    return evaluate(named.quantity, instant, named.derivative).derivatives[at(named.derivative)];
}

}  // namespace

Instant instant_of(
    Simulation& simulation, const Snapshot& snapshot, const std::vector<double>& y,
    std::shared_ptr<const Centroidal> scene, std::shared_ptr<const System> system, bool with_accelerations) {
    Instant instant;
    instant.t = snapshot.t;
    instant.state = snapshot.state;
    instant.velocity = snapshot.velocity;
    instant.turns = snapshot.turns;
    instant.energy = Energy{snapshot.kinetic, snapshot.potential};
    instant.scene = std::move(scene);
    if (with_accelerations) {
        instant.centroidal_acceleration = simulation.acceleration(snapshot.t, y);
        instant.acceleration = simulation.acceleration_as_given(y, *instant.centroidal_acceleration);
    }
    instant.system = std::move(system);
    return instant;
}

std::string instants_by_forces(
    const Lesson& lesson, const RunLimits& limits, const std::vector<double>& times,
    std::map<double, Instant>& found) {
    const DynamicsPlan& plan = *lesson.dynamics;
    SimulationSettings settings;
    const MethodName& method = entry_of(plan.settings.method);
    settings.method = method.kind == MethodKind::radau ? plan.settings.method : Method::explicit_8;
    settings.tolerance = limits.tolerance;
    settings.most_steps = limits.most_steps;
    Simulation simulation(taking_part(lesson), plan.loads, settings);
    simulation.follow_angles();
    System system(lesson.mechanism, selection_of(lesson, static_cast<int>(lesson.order.size())));
    const SimulationOutcome outcome = simulation.run(times, [&](double t, const std::vector<double>& y) {
        const Snapshot now = simulation.snapshot(t, y);
        system.choose_rows(now.state);
        found[t] = instant_of(
            simulation, now, y, std::make_shared<const Centroidal>(simulation.scene()),
            std::make_shared<const System>(system), true);
    });
    return outcome.failure ? failure_text(*outcome.failure, settings, lesson) : std::string();
}

DynamicsRows::DynamicsRows(
    const Lesson& lesson, const std::vector<NamedQuantity>& further, Simulation& simulation)
    : further_(further),
      simulation_(&simulation),
      list_(columns_of_run(lesson)),
      system_(std::make_shared<System>(lesson.mechanism, everything(lesson.mechanism))),
      scene_(std::make_shared<const Centroidal>(simulation.scene())) {
    if (!further_.empty()) { simulation.follow_angles(); }
}

std::vector<std::string> DynamicsRows::columns() const {
    const Mechanism& mechanism = system_->mechanism();
    std::vector<std::string> columns{"time_s"};
    for (const NamedQuantity& q : list_) { columns.push_back(name_of(q.quantity, q.derivative, mechanism)); }
    columns.insert(columns.end(), {"position_violation", "velocity_violation", "p_drift"});
    for (const NamedQuantity& q : further_) {
        columns.push_back(name_of(q.quantity, q.derivative, mechanism));
    }
    return columns;
}

std::vector<double> DynamicsRows::row(const Snapshot& now, const std::vector<double>& y) {
    const bool further = !further_.empty();
    if (further) {
        system_->choose_rows(now.state);
        // only the run knows the counted turns of springs
        if (depends_on_turns(scene_->loads)) {
            scene_ = std::make_shared<const Centroidal>(simulation_->scene());
        }
    }
    const Instant instant = instant_of(*simulation_, now, y, scene_, system_, further);
    std::vector<double> row{now.t};
    for (const NamedQuantity& q : list_) { row.push_back(number_of(q, instant)); }
    row.insert(row.end(), {now.position_violation, now.velocity_violation, now.p_drift});
    for (const NamedQuantity& q : further_) { row.push_back(number_of(q, instant)); }
    return row;
}

}  // namespace jw
