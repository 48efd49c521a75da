#include "app/snapshot/fact_list.hpp"
#include "app/snapshot/facts_of_loads.hpp"
#include "lessons/lesson/lesson.hpp"

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
    add_loads(loads, lesson.mechanism, facts);
    return facts.take();
}

}  // namespace jw::snapshot
