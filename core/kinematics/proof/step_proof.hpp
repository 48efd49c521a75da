#pragma once

#include <memory>

#include "core/model/mechanism.hpp"

/// Proof that a step of a driven motion stays on its branch.
namespace jw {

class System;

/// Pose of a motion and its velocity at one time.
struct PathEnd {
    double t = 0.0;
    const State* state = nullptr;
    const Motion* velocity = nullptr;
};

/// Proves that between two poses exactly one solution of Φ(q, t) = 0 leads from one to the other.
///
/// x̂(t) is the cubic Hermite polynomial in (r, p) through both ends and their velocities, M the inverse of
/// the Jacobian J at a pose nearby, the anchor. If for all t of the step and all x with |x - x̂(t)| ≤ ρ
///
///   |M Φ(x̂(t), t)| ≤ α,   |I - M J(x, t)| ≤ K,   α + K ρ < ρ
///
/// then x - M Φ(x, t) is a contraction of that tube: for each t it contains exactly one solution, which
/// depends continuously on t, and J is regular in all of it. Norms are taken by blocks, r and p of each body,
/// so that no scale enters. Bounds of derivatives come from the primitives' own lines (jets/majorants.hpp):
///
///   |Φ(x̂(t), t)| ≤ its values at both ends + 4h/27 its rates there + h⁴/384 max |d⁴Φ/dt⁴|
///   |I - M J(x, t)| ≤ |I - M J| at the anchor + Σ |M| |∂²Φ| |x - anchor|
///
/// Parts of the mechanism that determine their poses one after the other are proved one after the other.
///
/// Redundant equations: the most independent ones are proved; the others hold within rounding at both ends.
/// What is left free follows x̂ by definition: for a single body or, with LeftFree::kept, for several
/// together.
/// @source Kantorovich's theorem; docs/proofs.md
class StepProof {
public:
    /// Statement of a proof about bodies that are left free together: none, since drivers do not determine
    /// their poses; or that one solution follows x̂ in that freedom.
    enum class LeftFree { undetermined, kept };

    /// @param system must outlive this
    explicit StepProof(const System& system, LeftFree left_free = LeftFree::undetermined);
    ~StepProof();

    /// True if the step is proved; if it is not, a shorter one may be. Near a singular pose, none can be: see
    /// decides_at.
    bool holds(const PathEnd& from, const PathEnd& to);
    /// True if the last `holds` is about all bodies: no part is too large, or left free.
    bool covers_all() const;
    /// False if rounding hides the branch: no step from this pose can be proved, however short.
    bool decides_at(const PathEnd& pose);
    /// 1 / |M| at the pose of the last query, for the part nearest to a singular pose: proportional to the
    /// distance from there; its square is proportional to the time until a turning point.
    double margin() const;
    /// 1 / |M| at the anchors of the last proved step, of the part nearest to a singular pose.
    double margin_nearby() const;
    /// True if drivers leave several bodies free together: nothing is proved about these, and their poses are
    /// not determined.
    bool leaves_bodies_free(const PathEnd& pose);

private:
    class Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace jw
