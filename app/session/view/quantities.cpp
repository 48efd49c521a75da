#include "app/session/view/quantities.hpp"

#include "app/session/wording/quantity_text.hpp"
#include "core/quantity/names.hpp"

namespace jw {

namespace {

QuantityMotion motion_of(const MeasureQuantity& quantity, const Instant& instant, bool driven) {
    const Mechanism& mechanism = instant.system->mechanism();
    const QuantityValue v = evaluate(quantity, instant);
    const double factor = factor_of_unit(quantity);
    return {
        name_of(quantity, 0, mechanism),
        unit_text(quantity, 0),
        driven,
        factor * v.value(),
        factor * v.rate(),
        factor * v.acceleration(),
        name_of(quantity, 1, mechanism),
        name_of(quantity, 2, mechanism)};
}

}  // namespace

Instant instant_of(const Step& step) {
    Instant instant;
    instant.t = step.t;
    instant.system = step.system;
    instant.state = step.state;
    instant.velocity = step.velocity;
    instant.turns = step.turns;
    if (step.kind == Step::Kind::motion) { instant.acceleration = step.acceleration; }
    instant.scene = step.centroidal;
    if (step.centroidal) { instant.centroidal_acceleration = step.centroidal_acceleration; }
    instant.energy = step.energy;
    return instant;
}

std::vector<QuantityMotion> quantities_of(const Step& step) {
    const System& system = *step.system;
    const Mechanism& mechanism = system.mechanism();
    const Instant instant = instant_of(step);
    std::vector<QuantityMotion> quantities;
    for (const DriverConstraint& d : system.drivers()) {
        quantities.push_back(motion_of(measure_of_driver(mechanism, d.driver), instant, true));
    }
    for (const int j : system.selection().joints) {
        for (const MeasureQuantity& measure : measures_of(mechanism, j)) {
            bool known = false;
            const std::string name = name_of(measure, 0, mechanism);
            for (const QuantityMotion& q : quantities) { known = known || q.name == name; }
            if (!known) { quantities.push_back(motion_of(measure, instant, false)); }
        }
    }
    return quantities;
}

}  // namespace jw
