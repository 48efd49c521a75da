#include "jointwise/analysis.hpp"

#include "jointwise/evaluator.hpp"
#include "library/convert.hpp"
#include "library/inside.hpp"

/// Each function makes an Evaluator for its pose, and uses it once.
namespace jointwise {
inline namespace JOINTWISE_ABI {

namespace {

Evaluator evaluator_at(
    const Mechanism& mechanism, const Pose& pose, Coordinates coordinates = Coordinates::omega_local) {
    Evaluator evaluator(mechanism, coordinates);
    evaluator.choose_rows(pose);
    return evaluator;
}

}  // namespace

Pose start_pose(const Mechanism& mechanism) {
    return pose_of(jw::start_state(mechanism.inside().mechanism), 0.0);
}

Rates start_rates(const Mechanism& mechanism) {
    return rates_of(jw::start_motion(mechanism.inside().mechanism));
}

Pose assemble(const Mechanism& mechanism, double t) { return assemble(mechanism, start_pose(mechanism), t); }

Pose assemble(const Mechanism& mechanism, const Pose& estimate, double t) {
    return evaluator_at(mechanism, estimate).assemble(estimate, t);
}

Equations equations_at(
    const Mechanism& mechanism, const Pose& pose, const Rates& velocities, Coordinates coordinates) {
    Equations equations;
    evaluator_at(mechanism, pose, coordinates).equations_at(pose, velocities, equations);
    return equations;
}

Rank rank_at(const Mechanism& mechanism, const Pose& pose) {
    return evaluator_at(mechanism, pose).rank_at(pose);
}

Rates velocities_at(const Mechanism& mechanism, const Pose& pose) {
    return evaluator_at(mechanism, pose).velocities_at(pose);
}

Rates accelerations_at(const Mechanism& mechanism, const Pose& pose, const Rates& velocities) {
    return evaluator_at(mechanism, pose).accelerations_at(pose, velocities);
}

}  // namespace JOINTWISE_ABI
}  // namespace jointwise
