#include "core/kinematics/turning_point.hpp"

#include <algorithm>
#include <cmath>

#include "core/jets/drivers.hpp"
#include "core/kinematics/paths/free_path.hpp"
#include "core/kinematics/paths/free_proof.hpp"

namespace jw {

namespace {

// [rad, or sizes of the machine]: at a turning point the driver falls behind by half the square of the path,
// 5e-7 after the first step
constexpr double kFirstLength = 1e-3;
constexpr double kGrowthPastTurn = 2.0;
constexpr double kLongest = 0.05;
constexpr int kMostStepsPastTurn = 100;
// [rad, or units of length]: a thousand times the error of poses
constexpr double kBehind = 1e-9;
// far beyond what is needed, and a small part of a turn: angles are compared modulo a turn
constexpr double kGoesOn = 0.01;

Selection without(Selection selection, int driver) {
    std::erase(selection.drivers, driver);
    return selection;
}

}  // namespace

const DriverConstraint* only_moving_driver(const System& system, double t) {
    const DriverConstraint* found = nullptr;
    for (const DriverConstraint& driver : system.drivers()) {
        if (system.mechanism().drivers[at(driver.driver)].function.at(t).f_dot == 0.0) { continue; }
        if (found != nullptr) { return nullptr; }
        found = &driver;
    }
    return found;
}

bool turns_back(const System& system, const State& state, const Motion& velocity, double t, double sense) {
    const DriverConstraint* driver = only_moving_driver(system, t);
    if (driver == nullptr) { return false; }
    Assembler<OmegaLocal> assembler(system);
    const Driver& moves = system.mechanism().drivers[at(driver->driver)];
    const double unit =
        std::copysign(driver->unit, sense * target_of(moves.measure, moves.function, t).f_dot);
    const auto ahead_at = [&](const State& pose) {
        assembler.assemble_phi_and_jacobian(pose, t);
        return assembler.phi()(driver->row) / unit;
    };

    const Mechanism still = at_rest(system.mechanism(), t);
    System released(still, without(system.selection(), driver->driver));
    released.inherit_rows(system);
    FreePath path(released, state);
    PathPoint point{state, sense * assembler.layout().columns_of(state, velocity)};
    if (!path.make_free(point)) { return false; }
    double length = kFirstLength;
    for (int k = 0; k < kMostStepsPastTurn; ++k) {
        const double taken = path.take_proved_step(point, length);
        if (taken == 0.0) { return false; }
        const double ahead = ahead_at(point.state);
        if (ahead < -kBehind) { return true; }
        if (ahead > kGoesOn) { return false; }
        length = std::min(taken == length ? kGrowthPastTurn * length : taken, kLongest);
    }
    return false;
}

}  // namespace jw
