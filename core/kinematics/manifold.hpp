#pragma once

#include <vector>

#include "core/poses/newton.hpp"

/// Dragging on the manifold of assembled states: a point of a body is pulled, everything else follows.
namespace jw {

/// Rank by pivots at a pose assembled to `residual` (scaled). As in the motion tracker, the weakest equation
/// does not count where it is close to lost: near a singular pose it is mostly position error.
int reliable_rank(const LeastSquares& least_squares, double residual);

/// Moves `state` to a nearby assembled state by Newton's method; rows are chosen again there.
/// @return false, with `state` unchanged, if Newton's method does not converge to an intended state
bool project(System& system, State& state, double t);

/// Result of a pull.
struct DragOutcome {
    double distance = 0.0;  ///< from the point to the target [m]; 0 for a target that is ignored
    int freedoms = 0;       ///< columns - rank at the last pose
    bool blocked = false;   ///< short of the target, and no freedom moves the point towards it
    int newton_iterations = 0;
    double residual = 0.0;  ///< largest |Φ|, scaled
};

/// Drags an assembled state so that a point of a body comes as near as possible to a target. A pull is a few
/// steps along the free motions (r, ω'): Newton's method on the distance, with the curvature of the
/// constraints, each step corrected by Newton's method on Φ. A step is taken only if the distance decreases,
/// so pulls at a target out of reach end at the nearest point on the way there and stay. Time and drivers are
/// fixed.
class Dragger {
public:
    /// @param system must outlive this; its rows are chosen again between the steps
    /// @param state satisfies the constraints at time `t`
    Dragger(System& system, State state, double t);

    /// Takes at most five steps, each with rotations up to 0.2 rad and displacements up to a fifth of the
    /// machine. Targets that are not finite are ignored.
    /// @param point_local in the body [m]
    /// @param target global [m]
    /// @throws std::invalid_argument for a body that is not in the mechanism
    DragOutcome pull(int body, const Vec3& point_local, const Vec3& target);

    const State& state() const { return state_; }

private:
    Vec3 point(const State& state) const;
    void factor();
    bool step(DragOutcome& outcome);
    void find_direction();
    void curvature_along(const VectorX& direction, VectorX& curvature);
    void slope_at(const State& state, VectorX& slope);
    void keep_free_part(VectorX& scaled);
    void shorten_direction();
    bool correct(double fraction, DragOutcome& outcome);
    bool leads_on(const State& reached) const;
    void accept(const State& reached);

    System* system_;
    State state_;
    double t_;
    double size_;  ///< size of the machine [m]
    Assembler<OmegaLocal> assembler_;
    Scaling scaling_;
    LeastSquares least_squares_;
    NewtonStepper<OmegaLocal> newton_;
    std::vector<int> sides_;
    int rank_ = 0;
    double residual_ = 0.0;

    // pulled point
    int body_ = 0;
    Vec3 point_local_ = Vec3::Zero();
    Vec3 target_ = Vec3::Zero();
    Vec3 goal_ = Vec3::Zero();  ///< the target, or a point on the way to one that is far away

    // work space: scaled unknowns
    State trial_;
    State way_out_;
    VectorX multipliers_;
    VectorX slope_;
    VectorX slope_there_;
    VectorX direction_;
    VectorX conjugate_;
    VectorX rest_;
    VectorX curvature_;
    VectorX step_;
};

}  // namespace jw
