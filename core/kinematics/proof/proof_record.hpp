#pragma once

#include <memory>
#include <vector>

#include "core/kinematics/motion_tracker.hpp"
#include "core/kinematics/proof/parts.hpp"

/// Proofs of a motion, written for programs that know only the equations: docs/proofs.md. Numbers are in m
/// and rad; rows and columns are not scaled.
namespace jw {

/// A component of an equation.
struct ProofRow {
    int equation = 0;
    int component = 0;
};

/// Reason why a step is claimed without a proof.
enum class NoProof {
    none,
    nothing_drives,
    leaves_bodies_free,
    too_large,  ///< a part of more than kMostProvedColumns
    singular,   ///< no step here can be proved, however short: a change point, or rounding hides the branch
};

/// Pose and velocity of all coordinates, one after the other.
struct PoseRecord {
    double t = 0.0;
    VectorX x;
    VectorX x_dot;
};

struct PartRecord {
    std::vector<int> unknowns;   ///< coordinates
    std::vector<ProofRow> rows;  ///< rows that are proved
    MatrixX kept;                ///< rows w for the motions left free: w·(x - x̂) = 0
    MatrixX inverse;             ///< M, by unknowns, and by rows followed by those of `kept`
    VectorX radius;              ///< ρ of each of the unknowns
};

/// The step from a pose to the next.
struct StepRecord {
    std::vector<PartRecord> parts;  ///< empty if the step is not proved
    NoProof reason = NoProof::none;
};

/// Rank of all equations at the first pose.
struct RankRecord {
    std::vector<ProofRow> rows;  ///< independent ones
    std::vector<int> columns;    ///< of a minor that is regular
    MatrixX inverse;             ///< of the minor
    /// A redundant row: `row` = Σ combination(k) * rows[k], up to `misfit` in each column.
    struct Repeated {
        ProofRow row;
        VectorX combination;
        double misfit = 0.0;
    };
    std::vector<Repeated> repeated;
};

struct ProofRecord {
    std::vector<Coordinates> coordinates;
    std::vector<ProvedEquation> equations;
    State fixed;  ///< places of the fixed bodies; for the others, those at the first pose
    std::vector<PoseRecord> poses;
    std::vector<StepRecord> steps;
    RankRecord rank;  ///< no rows: the mechanism is too large
};

/// Records the frames of a motion with a proof of each interval, or of shorter intervals if needed: the pose
/// at a time does not depend on how many others are requested.
class ProofRecorder {
public:
    /// @param system must outlive this
    explicit ProofRecorder(const System& system);
    ~ProofRecorder();

    void add(const MotionFrame& frame);
    /// @return the record; nothing may be added afterwards
    ProofRecord take();

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace jw
