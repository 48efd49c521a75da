#include "app/snapshot/facts_of_loads.hpp"

#include "app/snapshot/units_of_keys.hpp"
#include "lessons/lesson/enum_words.hpp"

namespace jw::snapshot {

namespace {

const std::string& body_name(const Mechanism& mechanism, int body) {
    return mechanism.bodies[static_cast<std::size_t>(body)].name;
}

/// "force 1"
std::string counted(const char* kind, std::size_t from_zero) {
    return kind + (" " + std::to_string(from_zero + 1));
}

/// Parts of a function of time, each multiplied by `factor`.
void add_function(
    const TimeFunction& function, double factor, const std::string& name, const std::string& unit,
    FactList& facts) {
    const auto part = [&](const std::string& what, double value, const std::string& of_unit) {
        facts.given(Weight::pose, name + " · " + what, value, of_unit);
    };
    for (std::size_t k = 0; k < function.polynomial.size(); ++k) {
        part("c" + std::to_string(k), factor * function.polynomial[k], unit_of_coefficient(unit, k));
    }
    for (std::size_t k = 0; k < function.harmonics.size(); ++k) {
        const TimeFunction::Harmonic& harmonic = function.harmonics[k];
        const std::string which = counted("harmonic", k);
        part(which + " · amplitude", factor * harmonic.amplitude, unit);
        part(which + " · ω", harmonic.omega, "rad/s");
        part(which + " · phase", harmonic.phase, "rad");
    }
    for (std::size_t k = 0; k < function.steps.size(); ++k) {
        const TimeFunction::SmoothStep& step = function.steps[k];
        const std::string which = counted("step", k);
        part(which + " · from", factor * step.from, unit);
        part(which + " · to", factor * step.to, unit);
        part(which + " · start", step.start, "s");
        part(which + " · end", step.end, "s");
    }
    if (function.formula) {
        facts.text(Weight::pose, name + " · formula", function.formula->formula.source);
        part("unit of the formula", factor * function.formula->unit, unit);
    }
    if (!function.table) { return; }
    const TimeTable& table = *function.table;
    facts.text(Weight::pose, name + " · between values", word_of(kInterpolations, table.interpolation));
    for (std::size_t k = 0; k < table.times.size(); ++k) {
        const std::string which = counted("value", k);
        part(which + " · time", table.times[k], "s");
        part(which, factor * table.values[k], unit);
    }
}

/// Adds the facts that forces and torques share. A constant load is a vector with its unit. For other loads,
/// the direction has length 1, so that a factor means the same wherever it is written.
template <class Load>
void add_vector(const Load& load, const std::string& name, const std::string& unit, FactList& facts) {
    facts.text(Weight::pose, name + " · frame", word_of(kFrames, load.frame));
    const TimeFunction& magnitude = load.magnitude;
    if (magnitude.harmonics.empty() && magnitude.steps.empty() && !magnitude.table && !magnitude.formula &&
        magnitude.polynomial.size() == 1) {
        facts.given(Weight::pose, name, magnitude.polynomial.front() * load.direction, unit);
        return;
    }
    const double length = load.direction.norm();
    facts.given(Weight::pose, name + " · direction", load.direction.normalized(), "");
    add_function(magnitude, length, name, unit, facts);
}

void add_forces(const Loads& loads, const Mechanism& mechanism, FactList& facts) {
    for (std::size_t k = 0; k < loads.forces.size(); ++k) {
        const std::string name = counted("force", k);
        facts.text(Weight::count, name, "on " + body_name(mechanism, loads.forces[k].body));
        facts.given(Weight::pose, name + " · at", loads.forces[k].point_local, "m");
        add_vector(loads.forces[k], name, "N", facts);
    }
    for (std::size_t k = 0; k < loads.torques.size(); ++k) {
        const std::string name = counted("torque", k);
        facts.text(Weight::count, name, "on " + body_name(mechanism, loads.torques[k].body));
        if (loads.torques[k].against >= 0) {
            facts.text(Weight::pose, name + " · against", body_name(mechanism, loads.torques[k].against));
        }
        add_vector(loads.torques[k], name, "N m", facts);
    }
}

void add_friction(
    const DryFriction& friction, const std::string& name, const char* force, const char* rate,
    FactList& facts) {
    if (friction == DryFriction{}) { return; }
    facts.given(Weight::pose, name + " · friction", friction.size, force);
    facts.given(Weight::pose, name + " · speed of friction", friction.speed, rate);
}

void add_spring(const Spring& spring, const std::string& name, FactList& facts) {
    facts.given(Weight::pose, name + " · from", spring.P_i_local, "m");
    facts.given(Weight::pose, name + " · to", spring.P_j_local, "m");
    facts.given(Weight::pose, name + " · stiffness", spring.stiffness, "N/m");
    if (spring.s_i_local) { facts.given(Weight::pose, name + " · axis", *spring.s_i_local, ""); }
    facts.given(Weight::pose, name + " · free length", spring.free_length, "m");
    facts.given(Weight::pose, name + " · damping", spring.damping, "N s/m");
    add_friction(spring.friction, name, "N", "m/s", facts);
    if (spring.law) { facts.text(Weight::pose, name + " · law", spring.law->source); }
}

void add_spring(const RotationalSpring& spring, const std::string& name, FactList& facts) {
    facts.given(Weight::pose, name + " · stiffness", spring.stiffness, "N m/rad");
    facts.given(Weight::pose, name + " · free angle", spring.free_angle, "rad");
    facts.given(Weight::pose, name + " · damping", spring.damping, "N m s/rad");
    add_friction(spring.friction, name, "N m", "rad/s", facts);
    if (spring.law) { facts.text(Weight::pose, name + " · law", spring.law->source); }
}

template <class Springs>
void add_springs(const Springs& springs, const Mechanism& mechanism, const char* kind, FactList& facts) {
    for (std::size_t k = 0; k < springs.size(); ++k) {
        const std::string name = counted(kind, k);
        facts.text(
            Weight::count, name,
            body_name(mechanism, springs[k].body_i) + " – " + body_name(mechanism, springs[k].body_j));
        add_spring(springs[k], name, facts);
    }
}

/// Adds the joints that each rotational spring acts about: two springs between the same bodies may have
/// different axes.
void add_axes(const Loads& loads, const Mechanism& mechanism, FactList& facts) {
    for (std::size_t k = 0; k < loads.rotational_springs.size(); ++k) {
        std::string names;
        for (const Joint& joint : mechanism.joints) {
            if (!acts_about(loads.rotational_springs[k], joint)) { continue; }
            names += (names.empty() ? "" : ", ") + joint.name;
        }
        facts.text(Weight::pose, counted("rotational spring", k) + " · about", names);
    }
}

}  // namespace

void add_loads(const Loads& loads, const Mechanism& mechanism, FactList& facts) {
    add_forces(loads, mechanism, facts);
    add_springs(loads.springs, mechanism, "spring", facts);
    add_springs(loads.rotational_springs, mechanism, "rotational spring", facts);
    add_axes(loads, mechanism, facts);
}

}  // namespace jw::snapshot
