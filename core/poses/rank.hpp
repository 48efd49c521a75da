#pragma once

#include <optional>
#include <vector>

#include "core/equations/system.hpp"

/// The kinematic rank of a system: how many of its equations are independent, which others imply the
/// redundant ones, and which motions are left free. Always judged on the (r, ω') matrix: (r, p) without the
/// rows pᵀp = 1 hides redundancy, since a change of |p| acts as a false freedom.
namespace jw {

/// Relative threshold of a vanishing singular value. That of a redundant row is about half the position
/// error, so the threshold is `kErrorFactor` times the residual if that is larger.
inline constexpr double kRankThreshold = 1e-9;
inline constexpr double kErrorFactor = 10.0;
/// Residual (scaled) above which the state counts as not assembled, and the rank is that of the matrix only.
inline constexpr double kAssembledResidual = 1e-4;
/// Ratio σ_r / σ_(r-1) below which a pose is reported as near a singular position.
inline constexpr double kNearSingularRatio = 1e-3;

/// Redundant equation as a combination of others.
struct RedundantRow {
    struct Term {
        int row = 0;
        double coefficient = 0.0;
    };
    int row = 0;
    std::vector<Term> terms;  ///< row = Σ coefficient * Φq row, terms below 1e-9 of the largest left out
    double misfit = 0.0;      ///< norm of the difference from the remaining terms, scaled
    double bound = 0.0;       ///< bound of `misfit` from the singular values that count as zero, and rounding
};

/// Direction of free motion, scaled so that its largest entry is 1. Columns of (r, ω') and θ.
using FreeMotion = VectorX;

/// Residual ‖Φq v‖ / ‖v‖ of a free motion v, scaled, and its bound: the largest singular value that counts as
/// zero, and rounding.
struct FreeMotionProof {
    double residual = 0.0;
    double bound = 0.0;
    /// True if rounding explains the residual.
    bool holds() const { return residual <= bound; }
};

/// Rank of Φq at a state, with redundant rows, free motions and the margin of the verdict.
struct RankReport {
    int rows = 0;
    int columns = 0;
    int rank = 0;
    int dof = 0;  ///< columns - rank
    int mobility_by_counting =
        0;  ///< Grübler: columns minus the equations that the joint types promise, less those taken out
    VectorX singular_values;            ///< of the scaled matrix in the scene's unit of length, largest first
    double threshold = 0.0;             ///< absolute threshold; singular values up to it count as zero
    double singular_value_error = 0.0;  ///< bound on their error (Svd::error)
    bool sound = true;                  ///< false: the decomposition did not pass its check (Svd::sound)
    /// Uncertainty of σ_r, the last singular value that counts, due to the residual: a position is known to
    /// about residual / σ_r, and Φq changes by as much.
    double pose_error = 0.0;
    /// False if the rank is undecided: σ_r or σ_(r+1) is within its error of the threshold, the decomposition
    /// does not pass its check, or typed digits leave it undecided.
    bool decided = true;
    std::optional<TypedVerdict> typed;  ///< if the digits of all joints decide
    double residual = 0.0;              ///< largest |Φ|, scaled
    double largest_gap = 0.0;           ///< σ_r / max(σ_(r+1), rounding): the margin of the verdict
    bool assembled = true;              ///< false: the residual is so large that only the matrix is described
    bool near_singular = false;         ///< σ_r is small against σ_(r-1)
    std::vector<RedundantRow> redundant_rows;
    std::vector<FreeMotion> free_motions;
    std::vector<FreeMotionProof> free_motion_proofs;  ///< one per free motion
    /// False for large matrices (large_rank.hpp): singular values and free motions were not computed; the
    /// first and the last singular value that counts were estimated.
    bool has_spectrum = true;
    double estimated_first = 0.0;
    double estimated_last = 0.0;

    int redundant() const { return rows - rank; }
    /// σ_1 and σ_r; 0 if the rank is 0.
    double first_value() const;
    double last_value() const;
};

/// Extent of a report: the redundant rows and the free motions take as long as the verdict.
enum class RankDetail { everything, verdict };

/// Determines rank, redundant rows and free motions at a state.
/// @param jacobian the (r, ω') matrix at a state [rows x columns], as Assembler<OmegaLocal> gives it
/// @param phi residuals at that state
/// @param detail verdict: redundant rows and free motions are left out
RankReport analyse_rank(
    const System& system, const MatrixX& jacobian, const VectorX& phi,
    RankDetail detail = RankDetail::everything);

/// Rows, ascending, any single one of which may be removed without a loss of rank: the redundant ones and all
/// rows of which they are combinations. This does not hold for two rows together.
std::vector<int> removable_rows(const RankReport& report);

/// Singular values of any matrix, largest first.
VectorX singular_values_of(const MatrixX& matrix);

/// Explains the choice of rows of one p1 / p2 constraint at `state`: the condition of each pair of rows.
/// @param previous the index that was left out before
RowChoice explain_choice(const System& system, int constraint, const State& state, int previous);

}  // namespace jw
