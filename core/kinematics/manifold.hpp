#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/kinematics/paths/free_proof.hpp"
#include "core/poses/newton.hpp"

/// Dragging on the manifold of assembled states: a point of a body is pulled, everything else follows.
namespace jw {

/// Rank by pivots at a pose assembled to `residual` (scaled).
int rank_of_all(const LeastSquares& least_squares, double residual);
/// Rank without the weakest equation if that is nearly lost, as in the motion tracker: near a singular pose,
/// this equation is mostly position error.
int reliable_rank(const LeastSquares& least_squares, double residual);

/// Moves `state` to a nearby assembled state by Newton's method; rows are chosen again there.
/// @return false, with `state` unchanged, if Newton's method does not converge to an intended state
bool project(System& system, State& state, double t);

/// Result of a pull.
struct DragOutcome {
    double distance = 0.0;  ///< from the point to the target [m]; 0 for a target that is ignored
    int freedoms = 0;       ///< columns - rank at the last pose
    bool blocked = false;   ///< not at the target, and no freedom moves the point towards it
    int newton_iterations = 0;
    double residual = 0.0;  ///< largest |Φ|, scaled
};

/// Drags an assembled state so that a point of a body comes as near as possible to a target. A pull is a few
/// steps along the free motions (r, ω'): Newton's method on the distance, with the curvature of the
/// constraints; each step is corrected by Newton's method on Φ. A step is taken only if the distance
/// decreases, so pulls at a target out of reach end at the nearest point on the way there and stay. Time and
/// drivers are fixed.
///
/// In loops, a step is halved until it is proved to stay on its branch (FreeProof). Nothing can be proved
/// where branches meet or rounding hides them, and in loops of many bodies a proof takes too long. In these
/// cases a step is taken if it stays near its tangent, or leads on from a corner.
class Dragger {
public:
    /// @param system must outlive this; its rows are chosen again between the steps
    /// @param state satisfies the constraints at time `t`
    Dragger(System& system, State state, double t);

    /// Takes steps that add up to at most five whole ones; a whole one turns a body by up to 0.2 rad or
    /// displaces it by a fifth of the machine. Targets that are not finite are ignored.
    /// @param point_local in the body [m]
    /// @param target global [m]
    /// @throws std::invalid_argument for a body that is not in the mechanism
    DragOutcome pull(int body, const Vec3& point_local, const Vec3& target);

    const State& state() const { return state_; }

private:
    /// Prediction for a direction of a pull: ½ distance², and its decrease along the whole direction.
    struct Promise {
        double value = 0.0;
        double gain = 0.0;
        double share = 1.0;  ///< length of the direction, as a share of a whole step

        bool is_rounding(double fraction) const;
    };

    Vec3 point(const State& state) const;
    void factor(const State& state, LeastSquares& least_squares);
    double residual() const;
    Promise find_way(int rank);
    double step(DragOutcome& outcome);
    std::optional<double> proved_step(DragOutcome& outcome);
    bool step_along_tangent(const Promise& promise, DragOutcome& outcome);
    int polish();
    bool is_proved(double fraction);
    bool is_decided(const State& state);
    void find_direction();
    void curvature_along(const VectorX& direction, VectorX& curvature);
    void slope_at(const State& state, VectorX& slope);
    void keep_free_part(VectorX& scaled);
    double shorten_direction();
    bool gains(double fraction, const Promise& promise) const;
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
    LeastSquares least_squares_there_;  ///< at the end of a step
    bool is_factored_ = false;          ///< `least_squares_` belongs to the state and its rows
    bool is_singular_ = false;          ///< more equations are independent at the end of the step
    std::unique_ptr<FreeProof> proof_;  ///< if there are loops
    int proofs_left_ = 0;               ///< proofs that this pull may still try
    double reach_ = 1.0;                ///< share of a whole step that was proved last: tried first

    // pulled point
    int body_ = 0;
    Vec3 point_local_ = Vec3::Zero();
    Vec3 target_ = Vec3::Zero();
    Vec3 goal_ = Vec3::Zero();  ///< the target, or a point on the way if it is far away

    // work space: scaled unknowns
    State trial_;
    State reached_;
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
