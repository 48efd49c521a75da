#include "app/snapshot/fact_list.hpp"
#include "lessons/lesson.hpp"

namespace jw::snapshot {

namespace {

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

void add_spring(const Spring& spring, const std::string& name, FactList& facts) {
    facts.given(Weight::pose, name + " · from", spring.P_i_local, "m");
    facts.given(Weight::pose, name + " · to", spring.P_j_local, "m");
    facts.given(Weight::pose, name + " · stiffness", spring.stiffness, "N/m");
    facts.given(Weight::pose, name + " · free length", spring.free_length, "m");
    facts.given(Weight::pose, name + " · damping", spring.damping, "N s/m");
}

void add_spring(const RotationalSpring& spring, const std::string& name, FactList& facts) {
    facts.given(Weight::pose, name + " · stiffness", spring.stiffness, "N m/rad");
    facts.given(Weight::pose, name + " · free angle", spring.free_angle, "rad");
    facts.given(Weight::pose, name + " · damping", spring.damping, "N m s/rad");
}

/// Springs have no names: they are counted.
template <class Springs>
void add_springs(const Springs& springs, const Mechanism& mechanism, const char* kind, FactList& facts) {
    const auto body = [&](int k) { return mechanism.bodies[static_cast<std::size_t>(k)].name; };
    for (std::size_t k = 0; k < springs.size(); ++k) {
        const std::string name = kind + (" " + std::to_string(k + 1));
        facts.text(Weight::count, name, body(springs[k].body_i) + " – " + body(springs[k].body_j));
        add_spring(springs[k], name, facts);
    }
}

}  // namespace

std::vector<Fact> facts_of(const Lesson& lesson) {
    FactList facts;
    facts.text(Weight::text, "title of the lesson", lesson.title);
    if (!lesson.dynamics) { return facts.take(); }
    const Loads& loads = lesson.dynamics->loads;
    facts.given(Weight::pose, "gravity", loads.gravity, "m/s²");
    for (std::size_t k = 0; k < loads.masses.size(); ++k) {
        if (loads.masses[k]) { add_mass(*loads.masses[k], lesson.mechanism.bodies[k].name, facts); }
    }
    add_springs(loads.springs, lesson.mechanism, "spring", facts);
    add_springs(loads.rotational_springs, lesson.mechanism, "rotational spring", facts);
    return facts.take();
}

}  // namespace jw::snapshot
