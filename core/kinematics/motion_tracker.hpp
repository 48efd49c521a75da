#pragma once

#include <memory>

#include "core/kinematics/kinematics.hpp"
#include "core/poses/position.hpp"

/// Tracking of the motion of a driven mechanism through time, on its branch.
namespace jw {

class DrivenFrames;

/// Ratio of the last pivot to the one before below which a pose is reported as a change point.
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
    LinearVerdict velocity_verdict;
    LinearVerdict acceleration_verdict;
    int substeps = 1;
    bool rows_switched = false;  ///< a p1 / p2 choice changed since the last frame
    bool change_point = false;   ///< singular pose or nearly so, passed along the previous tangent
};

/// Predictor-corrector: predicts along velocity and acceleration, corrects with Newton's method, and halves
/// the step where the correction is not small against the step, which indicates a jump to another branch.
/// Where the rows are sound and leave no freedom, it uses the fast solver DrivenFrames; elsewhere it
/// determines ranks.
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

private:
    void restart_quick_way();
    bool try_step(double h);
    bool try_quick_step(double h);
    bool try_thorough_step(double h);
    void analyse(double h);
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
    std::optional<PositionFailure> failure_;
};

}  // namespace jw
