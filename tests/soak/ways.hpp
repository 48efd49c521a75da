#pragma once

#include <string>
#include <vector>

#include "core/integrate/simulation.hpp"
#include "tests/soak/property.hpp"

/// Ways to move a generated mechanism.
namespace jw::test {

struct Way {
    std::string name;
    SimulationSettings settings;
};

/// Every method with a tolerance, explicit-8 in joints, in bodies and in dense (r, p).
std::vector<Way> ways();

/// `times` and, between their ends, those at which a function of time has a jump in a derivative.
std::vector<double> with_events(const Generated& generated, std::vector<double> times);

/// True if rows are kept by hand: such rows may lose their rank on the way.
bool keeps_rows_by_hand(const Mechanism& mechanism);

}  // namespace jw::test
