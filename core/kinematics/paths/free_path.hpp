#pragma once

#include <vector>

#include "core/equations/assembler.hpp"
#include "core/kinematics/proof/step_proof.hpp"
#include "core/poses/least_squares.hpp"
#include "core/poses/newton.hpp"

/// Paths of free motions, which are followed step by step and proved.
namespace jw {

/// Pose of a free motion and its tangent there.
struct PathPoint {
    State state;
    VectorX direction;  ///< columns of (r, ω') and θ; the largest turn, displacement in sizes, or θ is 1
};

/// Follows free motions of a mechanism whose drivers stand still, so that time is the length of the path.
class FreePath {
public:
    /// @param system is copied: rows are chosen again on the way
    /// @param start satisfies the constraints
    FreePath(const System& system, const State& start);

    /// Follows a direction from `point` by the tangent nearest to the previous one.
    /// @return the point and those after it, one per step
    std::vector<PathPoint> follow(PathPoint point, int steps, double length);

    /// True if it is proved that a motion leads along `path`, whose points are `length` apart, for `steps`
    /// steps from its point `first` on.
    bool proves(const std::vector<PathPoint>& path, double length, std::size_t first, std::size_t steps);

    /// Moves `point` to the assembled pose nearby, and its direction into the free motions there.
    /// @return false if no motion has this direction
    bool make_free(PathPoint& point);

    /// Moves `point` along the path by `length`, halved until the step is proved.
    /// @return the length, 0 if no step can be proved
    double take_proved_step(PathPoint& point, double length);

private:
    bool make_unit(VectorX& direction) const;
    bool advance(PathPoint& point, double length);
    double piece(State& state, VectorX& direction, double length);
    bool leads_on(const State& from, const State& prediction, const State& reached) const;
    VectorX difference(const State& from, const State& to) const;
    void keep_free_part(const State& state, VectorX& direction);
    bool assemble(PathPoint& point);
    PathEnd end_of(const PathPoint& point, double t, Motion& velocity) const;
    bool proves(const PathPoint& from, double t_from, const PathPoint& to, double t_to, int halvings);

    System system_;
    double size_;
    Assembler<OmegaLocal> assembler_;
    Scaling scaling_;
    LeastSquares least_squares_;
    NewtonStepper<OmegaLocal> newton_;
    std::vector<int> sides_;
    StepProof proof_;
    double holds_;         ///< largest |Φ| of an accepted pose, scaled
    double length_ = 0.0;  ///< of all steps of take_proved_step
};

}  // namespace jw
