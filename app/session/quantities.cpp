#include "app/session/quantities.hpp"
#include "app/session/numbers.hpp"

#include <cmath>

namespace jw {

namespace {

struct Source {
    std::string name;
    Measure measure;
    int body_i = 0;
    int body_j = 0;
    int theta = -1;
    bool driven = false;
};

bool is_angle(const Measure& measure) {
    return std::holds_alternative<AngleMeasure>(measure) || std::holds_alternative<ThetaMeasure>(measure);
}

QuantityMotion measured_of(const Source& source, const Step& step) {
    const Measured m = evaluate_measure(
        source.measure, source.body_i, source.body_j, source.theta, step.state, step.velocity,
        step.acceleration);
    QuantityMotion quantity{source.name, "m", source.driven, m.value, m.rate, m.acceleration};
    if (is_angle(source.measure)) {
        quantity.unit = "deg";
        quantity.value *= kDegreesPerRadian;
        quantity.rate *= kDegreesPerRadian;
        quantity.acceleration *= kDegreesPerRadian;
    } else if (std::holds_alternative<SquaredDistanceMeasure>(source.measure)) {
        const Measured distance = distance_of(m);
        quantity.value = distance.value;
        quantity.rate = distance.rate;
        quantity.acceleration = distance.acceleration;
    } else if (const auto* c = std::get_if<CoordinateMeasure>(&source.measure);
               c != nullptr && c->coordinate > 2) {
        quantity.unit = "-";
    }
    return quantity;
}

std::vector<Source> sources_of_joint(const Joint& joint, int theta) {
    const auto source = [&](const char* name, const Measure& measure) {
        return Source{joint.name + name, measure, joint.body_i, joint.body_j, theta, false};
    };
    const JointType& type = *joint.type;
    std::vector<Source> sources;
    if (type.artificial > 0) {
        sources.push_back(source(".angle", ThetaMeasure{}));
    } else if (type.has_angle()) {
        sources.push_back(source(".angle", angle_of(joint)));
    }
    if (type.has_displacement()) { sources.push_back(source(".displacement", displacement_of(joint))); }
    return sources;
}

}  // namespace

Measured distance_of(const Measured& squared) {
    const double d = std::sqrt(squared.value);
    const double rate = squared.rate / (2.0 * d);
    return {d, rate, (0.5 * squared.acceleration - rate * rate) / d};
}

std::string driver_quantity_name(const Mechanism& mechanism, const Driver& driver) {
    constexpr const char* coordinates[] = {".x", ".y", ".z", ".e0", ".e1", ".e2", ".e3"};
    if (const auto* c = std::get_if<CoordinateMeasure>(&driver.measure)) {
        return mechanism.bodies[static_cast<std::size_t>(driver.body_j)].name + coordinates[c->coordinate];
    }
    if (driver.joint < 0) { return driver.name + ".distance"; }
    return mechanism.joints[static_cast<std::size_t>(driver.joint)].name +
           (is_angle(driver.measure) ? ".angle" : ".displacement");
}

std::vector<QuantityMotion> quantities_of(const Step& step) {
    const System& system = *step.system;
    const Mechanism& mechanism = system.mechanism();
    const std::vector<int> thetas = mechanism.theta_indices();
    std::vector<QuantityMotion> quantities;
    for (const DriverConstraint& d : system.drivers()) {
        const Driver& driver = mechanism.drivers[static_cast<std::size_t>(d.driver)];
        QuantityMotion quantity = measured_of(
            {driver_quantity_name(mechanism, driver), driver.measure, driver.body_i, driver.body_j, d.theta,
             true},
            step);
        if (std::holds_alternative<AngleMeasure>(driver.measure)) {
            // a driven angle goes on beyond half a turn as its function does
            const double target = kDegreesPerRadian * driver.function.at(step.t).f;
            quantity.value = target + std::remainder(quantity.value - target, 360.0);
        }
        quantities.push_back(std::move(quantity));
    }
    for (const int j : system.selection().joints) {
        const auto k = static_cast<std::size_t>(j);
        for (const Source& source : sources_of_joint(mechanism.joints[k], thetas[k])) {
            bool known = false;
            for (const QuantityMotion& q : quantities) { known = known || q.name == source.name; }
            if (!known) { quantities.push_back(measured_of(source, step)); }
        }
    }
    return quantities;
}

}  // namespace jw
