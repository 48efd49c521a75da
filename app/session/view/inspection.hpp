#pragma once

#include <memory>
#include <string>

#include "app/session/story/story.hpp"
#include "app/session/view/dynamics_view.hpp"
#include "app/session/view/free_motions.hpp"
#include "core/kinematics/kinematic_residuals.hpp"

/// Every number of a system at one moment, in the coordinates that were asked for.
namespace jw {

struct Inspection {
    std::string moment;  ///< "step 7", "t = 0.25 s", "as given"
    int step = -1;       ///< -1 unless a step was asked for
    CoordinateChoice choice = CoordinateChoice::omega_local;
    std::shared_ptr<const System> system;
    State state;
    Motion velocity;  ///< the velocity that γ belongs to
    double t = 0.0;
    VectorX phi;
    SparseRows jacobian;
    VectorX nu;
    VectorX gamma;
    VectorX singular_values;            ///< of `jacobian` as it stands; empty where `rank` has no spectrum
    double singular_value_error = 0.0;  ///< bound on the error of each of them
    bool sound = true;                  ///< false: the singular values did not pass their check
    KinematicResiduals residuals;       ///< of the pose and of `velocity`; accelerations are not part of it
    RankReport rank;                    ///< kinematic, whatever the coordinates
    std::optional<DynamicsView> dynamics;  ///< of a moment of a motion by masses and forces
};

/// When singular values and free motions are computed.
enum class Spectrum {
    of_small,  ///< up to kMostColumnsWithSpectrum columns (large_rank.hpp)
    always,    ///< however long it takes: a minute for 500 bodies
};

/// True if the system has so few columns of (r, ω') that its Φq is shown with all of its zeros.
bool is_shown_dense(const Inspection& inspection);

/// Verdicts on the free motions of an assembled pose; empty for others.
FreedomJudgements judgements_of(const Inspection& inspection);

/// Inspection of a step of the story. Before the motion, γ belongs to the file's velocities; in the motion,
/// to those of the motion.
/// @throws std::out_of_range if there is no such step
Inspection inspect_step(
    const Story& story, int index, CoordinateChoice choice, Spectrum spectrum = Spectrum::of_small);

/// Inspection of the state of the file, with all joints and drivers, not assembled; γ belongs to the file's
/// velocities.
Inspection inspect_as_given(
    const Lesson& lesson, CoordinateChoice choice, Spectrum spectrum = Spectrum::of_small);

/// Inspection of the assembled mechanism, followed through the motion to time `t`.
/// @throws PoseNotReached
Inspection inspect_time(
    const Lesson& lesson, double t, CoordinateChoice choice, Spectrum spectrum = Spectrum::of_small);

/// Thrown if a pose could not be found; `what()` says why.
class PoseNotReached : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Exception that says why a story ended at its step `failed`, with the lesson's file name.
PoseNotReached not_reached(const Lesson& lesson, const Step& failed);
/// Exception that says why a pose of a motion was not reached.
PoseNotReached not_reached(const Lesson& lesson, const System& system, const PositionFailure& failure);

}  // namespace jw
