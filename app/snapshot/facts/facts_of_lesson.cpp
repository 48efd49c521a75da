#include "app/snapshot/facts/fact_list.hpp"
#include "core/motion/loads.hpp"
#include "lessons/lesson/enum_words.hpp"
#include "lessons/lesson/lesson.hpp"

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
    if (load.law) { facts.text(Weight::pose, name + " · law", load.law->formula.source); }
    const TimeFunction& magnitude = load.magnitude;
    if (!load.law && magnitude.harmonics.empty() && magnitude.steps.empty() && !magnitude.table &&
        !magnitude.formula && magnitude.polynomial.size() == 1) {
        facts.given(Weight::pose, name, magnitude.polynomial.front() * load.direction, unit);
        return;
    }
    // a law is told as it is written, so is its factor
    const double length = load.law ? 1.0 : load.direction.norm();
    facts.given(Weight::pose, name + " · direction", load.direction / length, "");
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

void add_spring(const Bushing& bushing, const std::string& name, FactList& facts) {
    facts.given(Weight::pose, name + " · from", bushing.P_i_local, "m");
    facts.given(Weight::pose, name + " · to", bushing.P_j_local, "m");
    for (const auto& [word, axis] : {std::pair{"x", 0}, {"z", 2}}) {
        facts.given(Weight::pose, name + " · " + word + " in the first", bushing.axes_i_local.col(axis), "");
        facts.given(Weight::pose, name + " · " + word + " in the second", bushing.axes_j_local.col(axis), "");
    }
    facts.given(Weight::pose, name + " · stiffness", bushing.stiffness, "N/m");
    facts.given(Weight::pose, name + " · damping", bushing.damping, "N s/m");
    facts.given(Weight::pose, name + " · rotational stiffness", bushing.rotational_stiffness, "N m/rad");
    facts.given(Weight::pose, name + " · rotational damping", bushing.rotational_damping, "N m s/rad");
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

/// Adds facts about forces, torques and springs. They have no names: those of each kind are counted from 1.
void add_loads(const Loads& loads, const Mechanism& mechanism, FactList& facts) {
    add_forces(loads, mechanism, facts);
    add_springs(loads.springs, mechanism, "spring", facts);
    add_springs(loads.rotational_springs, mechanism, "rotational spring", facts);
    add_axes(loads, mechanism, facts);
    add_springs(loads.bushings, mechanism, "bushing", facts);
}

void add_mass(const MassProperties& mass, const std::string& name, FactList& facts) {
    facts.given(Weight::pose, name + " · mass", mass.mass, "kg");
    facts.given(Weight::pose, name + " · centre of mass", mass.centre_local, "m");
    const Mat3& J = mass.J_local;
    const auto entry = [&](const char* which, double value) {
        facts.given(Weight::pose, name + " · J′ · " + which, value, "kg m²", J.norm());
    };
    entry("xx", J(0, 0));
    entry("yy", J(1, 1));
    entry("zz", J(2, 2));
    entry("xy", J(0, 1));
    entry("xz", J(0, 2));
    entry("yz", J(1, 2));
}

}  // namespace

std::string unit_of_coefficient(const std::string& unit, std::size_t power) {
    return power == 0 ? unit : power == 1 ? unit + "/s" : unit + "/s^" + std::to_string(power);
}

std::vector<Fact> facts_of(const Lesson& lesson) {
    FactList facts;
    facts.text(Weight::text, "title of the lesson", lesson.title);
    if (!lesson.dynamics) { return facts.take(); }
    const Loads& loads = lesson.dynamics->loads;
    facts.given(Weight::pose, "gravity", loads.gravity, "m/s²");
    for (std::size_t k = 0; k < loads.masses.size(); ++k) {
        if (loads.masses[k]) { add_mass(*loads.masses[k], lesson.mechanism.bodies[k].name, facts); }
    }
    add_loads(loads, lesson.mechanism, facts);
    return facts.take();
}

}  // namespace jw::snapshot
