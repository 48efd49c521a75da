#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "core/kinematics/joint_angles.hpp"
#include "core/kinematics/kinematics.hpp"
#include "core/kinematics/proof/step_proof.hpp"
#include "core/poses/position.hpp"

/// Tracking of the motion of a driven mechanism through time, on its branch.
namespace jw {

class DrivenFrames;

/// Ratio of the last pivot to the previous one below which a pose is reported as a change point.
inline constexpr double kChangePointRatio = 1e-3;
/// Ratio below which the weakest equation is left out of velocities and accelerations: at a change point
/// Newton's tolerance of 1e-13 determines a position only to its square root, 3e-7, and that equation is
/// mostly error.
inline constexpr double kLostPivotRatio = 1e-5;

/// State and motion at one time, with the verdicts on its equations.
struct MotionFrame {
    double t = 0.0;
    State state;
    Motion velocity;
    Motion acceleration;
    std::vector<int> turns;  ///< of every joint, see FollowedAngles
    LinearVerdict velocity_verdict;
    LinearVerdict acceleration_verdict;
    int substeps = 1;            ///< steps since the last frame
    int tries = 1;               ///< attempts at steps, including rejected ones: each is a proof
    bool rows_switched = false;  ///< a p1 / p2 choice changed since the last frame
    /// True at a singular or nearly singular pose: the rank is lower than at poses around it. The motion
    /// passes such a pose along the previous tangent.
    bool change_point = false;
};

/// Predictor-corrector: predicts along velocity and acceleration, corrects with Newton's method, and accepts
/// a step only if it is proved that the motion leads from one pose to the other (StepProof); otherwise it
/// takes a shorter step. So a pose does not depend on how many others are requested. Where rounding hides the
/// branch, at a change point, the motion continues along its tangent if that satisfies the equations, and
/// `change_point` says so. Where the rows are sound and leave no freedom, it uses the fast solver
/// DrivenFrames; elsewhere it determines ranks.
class MotionTracker {
public:
    /// @param system must outlive this; the rows of p1 / p2 are chosen again between frames
    /// @param state satisfies the constraints at time `t` [s]
    MotionTracker(System& system, State state, double t, bool with_accelerations = true);
    ~MotionTracker();

    const MotionFrame& frame() const { return frame_; }

    /// @return false if the motion could not be followed; `failure()` gives the reason, `frame()` stays at
    ///        the last good pose
    bool advance_to(double t);
    const std::optional<PositionFailure>& failure() const { return failure_; }
    /// Times at which the motion continued across a change point along its tangent, without a proof [s].
    const std::vector<double>& crossings() const { return crossings_; }

private:
    enum class Quick { accepted, rejected, declined };
    /// How a step is judged: by a proof; along the tangent where nothing drives; or across a change point.
    enum class Way { proved, tangent, crossing };

    void restart_quick_way();
    bool is_determined();
    bool stands_still_until(double t) const;
    int rank_beside();
    bool reach(double t);
    bool try_step(double h);
    Quick try_quick_step(double h);
    bool try_thorough_step(double h, Way way);
    bool cross(double t);
    /// Root of the square of StepProof::margin that the motion approaches.
    struct Root {
        enum class Kind { none, simple_root, double_root };
        Kind kind = Kind::none;
        double t = 0.0;
    };
    Root find_root();
    bool is_decided();
    void remember();
    void follow_angles();
    bool find_pose(double h, Way way);
    bool is_proved(
        const MotionFrame& from, const Motion& velocity, const MotionFrame& to, const Motion& to_velocity);
    bool satisfies_between(const MotionFrame& from, const MotionFrame& to);
    void analyse(double h);
    void polish(bool is_lost);
    void follow_branch();
    void explain_end(double t);

    System* system_;
    bool with_accelerations_;
    MotionFrame frame_;
    NewtonStepper<OmegaLocal> newton_;
    Kinematics<OmegaLocal> kinematics_;
    std::vector<int> sides_;
    int full_rank_ = 0;
    std::unique_ptr<DrivenFrames> quick_;
    bool quick_is_sound_ = false;
    MotionFrame reached_;
    FollowedAngles angles_;
    StepProof proof_;
    Motion path_velocity_;       ///< velocity from all equations; at change points, `frame_` omits one
    std::vector<double> kinks_;  ///< times at which a derivative of a driver jumps
    double step_ = HUGE_VAL;     ///< length of a step that can be proved [s]
    /// Pose that was proved, with its velocity.
    struct Proved {
        double t = 0.0;
        State state;
        Motion velocity;
        double margin = 0.0;  ///< StepProof::margin_nearby
    };
    std::vector<Proved> latest_;  ///< poses of the approach to a singular pose
    bool is_crossing_ = false;    ///< the frame was reached without a proof
    std::vector<double> crossings_;
    bool is_start_ = true;    ///< nothing has moved so far
    bool is_driven_ = false;  ///< drivers leave no bodies free together: steps are proved
    /// True at a singular or nearly singular pose, as judged by the rank of the motion so far.
    bool is_at_change_ = false;
    int rank_beside_ = 0;  ///< rank of poses beside the start, which may be singular
    std::optional<PositionFailure> failure_;
};

}  // namespace jw
