#include <cstdio>

#include "core/kinematics/kinematics.hpp"
#include "core/poses/position.hpp"
#include "core/poses/rank.hpp"
#include "tests/soak/motions.hpp"
#include "tests/soak/property.hpp"
#include "tests/support/driven.hpp"
#include "tests/support/generators/to_model.hpp"

/// Position, velocity and acceleration analysis, and rank.
namespace jw::test {

namespace {

namespace general = reference::general;

std::string number(const char* format, double value) {
    char text[80];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

}  // namespace

Verdict rank_agrees(const Generated& generated) {
    // core treats singular values below 1e-9 of the largest as zero; the pivots here are of unit rows in the
    // metric of M
    if (!(generated.condition < 1e5)) { return not_asked("too near to a singular pose"); }
    const RankReport report = rank_of(generated.mechanism);
    // every screw has a row and a column more: its artificial theta
    const int rank = report.rank - generated.mechanism.thetas_count();
    if (rank != generated.rank) {
        return fails("rank " + std::to_string(rank) + ", reference " + std::to_string(generated.rank));
    }
    if (!report.assembled) { return fails("an assembled start is said not to be assembled"); }
    if (static_cast<int>(report.redundant_rows.size()) != report.redundant()) {
        return fails("not every redundant row is explained");
    }
    for (const RedundantRow& row : report.redundant_rows) {
        // a combination is solved for in double: rounding times the condition of the other rows
        const double limit = 1e-9 * generated.condition;
        if (!(row.misfit <= limit)) {
            return fails("a combination misses its row by " + number("%.2g", row.misfit));
        }
    }
    return holds();
}

Verdict kinematics_agree(const Generated& generated) {
    if (generated.freedoms > 0) { return not_asked("the drivers leave something open"); }
    if (!(generated.condition < 1e4)) { return not_asked("too near to a singular pose"); }
    const Centroidal scene = centroidal(generated.mechanism, generated.loads);
    const Analysis found = analyse(scene.mechanism, start_state(scene.mechanism));
    general::Mechanics reference(model_of(generated.mechanism, generated.loads));
    const reference::VecX y = reference.start();
    const general::Accelerations a = reference.accelerations_at(y);
    const general::PlacedBodies placed = reference.bodies_at(y);
    const double L = generated.length;
    // rounding times the condition, which here also depends on masses and lengths of rows
    const double limit = 1e-11 * generated.condition;
    const double velocity = difference_of(found.velocity.velocity, start_motion(scene.mechanism), L);
    if (!(velocity <= limit * 10.0)) {
        return fails("velocities are off by " + number("%.2g 1/s", velocity));
    }
    const double acceleration = difference_of(found.acceleration.acceleration, motion_of(a, placed), L);
    if (!(acceleration <= limit * size_of(a, L))) {
        return fails("accelerations are off by " + number("%.2g 1/s2", acceleration));
    }
    return holds();
}

Verdict assembles_again(const Generated& generated) {
    if (!(generated.condition < 100.0)) { return not_asked("a small push may end on another branch"); }
    if (generated.rank == 0) { return not_asked("there is no constraint"); }
    Mechanism mechanism = generated.mechanism;
    Random random(static_cast<unsigned>(generated.recipe.seed));
    State state = disturbed(mechanism, start_state(mechanism), random, 0.003 * generated.length, 0.003);
    const System system(mechanism, everything(mechanism));
    const PositionOutcome outcome = solve_position<OmegaLocal>(system, state, 0.0);
    if (!outcome.ok()) { return fails("no position is found"); }
    // judged by equations that share nothing with those that were solved
    for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
        mechanism.bodies[b].r = state.r[b];
        mechanism.bodies[b].p = state.p[b];
    }
    general::Mechanics reference(model_of(mechanism, generated.loads));
    const reference::VecX y = reference.start();
    const general::PlacedBodies placed = reference.bodies_at(y);
    for (const general::Equation& equation : reference.model().equations) {
        const auto off = static_cast<double>(std::abs(general::phi_of(equation, placed, 0.0L).value));
        // lengths enter as such or squared
        const double size = std::max({1.0, generated.length, generated.length * generated.length});
        // Newton stops at 1e-13 in units of the scene, at 1e-7 where the typed numbers do not close
        if (!(off <= 1e-9 * size)) { return fails("an equation is off by " + number("%.2g", off)); }
    }
    return holds();
}

}  // namespace jw::test
