#include <cmath>
#include <iostream>

#include <jointwise/analysis.hpp>

using namespace jointwise;

/// A rod of 1 m and 1 kg on a hinge, let go when it is level: it keeps its energy.
int main() {
    Mechanism m;
    const int rod = m.add_body("rod", {0.5, 0.0, 0.0});
    m.add_joint("pin", "revolute", 0, rod, {.at = {0.0, 0.0, 0.0}, .axis = {0.0, 1.0, 0.0}});
    m.set_mass(rod, 1.0, Vector3(1e-4, 1.0 / 12.0, 1.0 / 12.0).asDiagonal());
    m.set_gravity({0.0, 0.0, -9.81});
    const std::vector<Moment> moments = simulate(m, {0.0, 0.5, 1.0}, {.tolerance = 1e-9});
    for (const Moment& moment : moments) {
        std::cout << "t = " << moment.pose.t << " s, height " << moment.pose.r[1].z() << " m\n";
    }
    // the tolerance of the integration, with the few steps of a second
    const bool kept = std::abs(moments.back().energy - moments.front().energy) < 1e-6;
    std::cout << "energy " << (kept ? "is kept" : "is lost") << '\n';
    return kept ? 0 : 1;
}
