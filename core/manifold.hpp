#pragma once

#include <vector>

#include "core/newton.hpp"

/// Motion by hand on the set of assembled states: a point of a body is pulled, everything else follows.
namespace jw {

/// Rank by pivots at a pose assembled to `residual` (scaled). As in the motion tracker the weakest equation
/// does not count where it is close to lost: next to a singular pose what it says is mostly position error.
int reliable_rank(const LeastSquares& least_squares, double residual);

/// Brings `state` to an assembled state next to it by Newton; rows are chosen there anew.
/// @return false, and `state` as it was, if Newton does not converge to a state that is meant
bool project(System& system, State& state, double t);

struct DragOutcome {
    double distance = 0.0;  ///< from the point to the target afterwards [m]; 0 for a target that is ignored
    int freedoms = 0;       ///< columns - rank at the last pose looked at
    bool blocked = false;   ///< short of the target, and no freedom moves the point towards it
    int newton_iterations = 0;
    double residual = 0.0;  ///< largest |Φ|, scaled
};

/// Moves an assembled state so that a point of a body comes as near as possible to a target. A pull is a few
/// steps along the free motions (r, ω'): Newton's method on the distance, with the curvature of the
/// constraints, each step corrected by Newton on Φ. A step is taken only if the distance falls, so pulls at a
/// target out of reach end at the nearest point of the way there and stay. Time and drivers stand still.
class Dragger {
public:
    /// @param system must outlive this; its rows are chosen anew between the steps
    /// @param state satisfies the constraints at time `t`
    Dragger(System& system, State state, double t);

    /// At most five steps, each with turns up to 0.2 rad and displacements up to a fifth of the machine.
    /// Numbers that are not finite are ignored.
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
    double size_;  ///< of the machine [m]
    Assembler<OmegaLocal> assembler_;
    Scaling scaling_;
    LeastSquares least_squares_;
    NewtonStepper<OmegaLocal> newton_;
    std::vector<int> sides_;
    int rank_ = 0;
    double residual_ = 0.0;

    // what is pulled
    int body_ = 0;
    Vec3 point_local_ = Vec3::Zero();
    Vec3 target_ = Vec3::Zero();
    Vec3 goal_ = Vec3::Zero();  ///< the target, or a place on the way to one that is far away

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
