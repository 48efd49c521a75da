#pragma once

#include <array>
#include <vector>

#include "core/eigen/decompositions.hpp"
#include "core/kinematics/proof/proved_step.hpp"

/// Proof of a step for one part of a mechanism.
namespace jw {

/// Bound of a second derivative of an equation: the column `of` of its Jacobian changes by `bound` times the
/// distance `along`. Both are places: unknowns first, then inputs, then targets.
struct Curvature {
    int equation = 0;
    int of = 0;
    int along = 0;
    double bound = 0.0;
};

/// Pose of a part with its inverse Jacobian M, and the bounds of derivatives around it. Rows of matrices are
/// the unknowns of the part.
struct Anchor {
    bool is_set = false;
    double t = 0.0;
    double reach = 1.0;                         ///< share of the largest region
    std::vector<Vec4> centre;                   ///< unknowns, then inputs
    std::vector<double> targets;                ///< per equation: θ of its driver
    std::vector<DerivativeBounds> derivatives;  ///< per equation, scaled
    std::vector<Curvature> curvatures;          ///< those that are not 0
    std::vector<double> rounding;               ///< per equation: of Φ there
    std::vector<BodyKinematics<Majorants>> i;   ///< per equation
    std::vector<BodyKinematics<Majorants>> j;
    MatrixX inverse;    ///< norms of M by unknowns and equations
    MatrixX defect;     ///< |I - M J| by unknowns
    MatrixX passed_on;  ///< |M ∂Φ/∂x| by unknowns and inputs
};

class ProvedPart {
public:
    /// @param step must outlive this
    ProvedPart(Part part, ProvedStep& step);

    /// Sets the trial anchor at an end of the step. @return false if the equations have another rank there
    bool try_anchor_at(const StepEnd& end) { return set_anchor(end, trial_); }
    void keep_trial() { std::swap(anchor_, trial_); }
    /// Time from the end of the step to the best place of the next anchor, which probably still proves this
    /// step [s]. 0 if the last anchor did not last long enough for that.
    double ahead() const;
    /// True if an anchor ahead of the step proves it; otherwise the choice of rows is unchanged or cleared.
    bool prove_ahead(const StepEnd& ahead);
    /// True if the anchor proves the step, whose error is then set.
    bool prove();
    bool prove_by_trial() { return prove(trial_); }
    /// 1 / |M| of the trial anchor.
    double margin() const { return 1.0 / trial_.inverse.norm(); }
    /// 1 / |M| of the anchor that proved the last step.
    double margin_of_anchor() const { return 1.0 / anchor_.inverse.norm(); }

private:
    int coordinates() const { return static_cast<int>(part_.unknowns.size() + part_.inputs.size()); }
    int coordinate(std::size_t k) const {
        return k < part_.unknowns.size() ? part_.unknowns[k] : part_.inputs[k - part_.unknowns.size()];
    }
    bool set_anchor(const StepEnd& end, Anchor& anchor);
    void bound_derivatives(const StepEnd& end, Anchor& anchor) const;
    bool has_formula() const;
    void choose_reach(const StepEnd& end, Anchor& anchor) const;
    bool choose_and_invert();
    bool has_same_rank() const;
    bool invert(const StepEnd& end, Anchor& anchor);
    void measure(Anchor& anchor) const;
    bool measure_reach(const Anchor& anchor);
    bool is_within_reach(const Anchor& anchor) const;
    void bound_residuals(Anchor& anchor);
    void add_errors_of_inputs(const Anchor& anchor, VectorX& errors) const;
    void find_bounds(const Anchor& anchor);
    bool prove(Anchor& anchor);
    bool contracts(const Anchor& anchor);

    Part part_;
    ProvedStep* step_;
    bool has_formula_;
    std::vector<int> first_column_;  ///< per unknown, and per input among the inputs
    int input_columns_ = 0;
    std::vector<std::array<int, kBlocks>> places_;  ///< per equation: unknowns, then inputs; -1: none
    Anchor anchor_;
    Anchor trial_;
    double lasted_ = 0.0;  ///< time for which an anchor proved later steps [s]

    // the matrix that is inverted
    std::vector<int> equation_of_row_;
    std::vector<int> chosen_;       ///< rows that are proved
    double size_of_inverse_ = 0.0;  ///< least since the rows were chosen
    MatrixX rows_;                  ///< transposed: the columns are rows of J, for pivoting
    MatrixX others_;                ///< derivatives with respect to the inputs
    MatrixX square_;
    MatrixX inverse_;
    MatrixX defect_;
    MatrixX input_rows_;
    MatrixX passed_on_;
    Eigen::ColPivHouseholderQR<MatrixX> qr_;
    std::vector<Eigen::Index> pivots_;

    // bounds of the step
    std::vector<double> reach_;     ///< per unknown, input and target: largest distance from the anchor
    std::vector<double> distance_;  ///< the same with ρ or the error of the input
    std::vector<double> residual_;  ///< per equation
    std::vector<double> passed_residual_;  ///< the same, with the errors of inputs added
    VectorX first_;                        ///< distance of the solution from x̂ if K were 0
    VectorX needed_;                       ///< radius to try, as multiples of `first_`
    VectorX radius_;
    VectorX alpha_;
    VectorX image_;
    MatrixX K_;
};

// The largest region around an anchor in which its bounds hold: a tube that leaves it needs another anchor. A
// larger region would weaken the bounds of rows that depend on distances.
inline constexpr double kReachOfP = 0.3;
inline constexpr double kReachOfLength = 0.3;  // in extents; for θ: 1 rad, or 1 m for a target
inline constexpr double kReachOfTheta = 1.0;
inline constexpr double kSizeOfP = 1.06;
// Error of a row: at most 8 roundings of its terms, counted as derivatives times coordinates. An arm A s' is
// off by 10 roundings of its length, which counts twice.
inline constexpr double kRoundingOfRow = 0x1p-50;

}  // namespace jw
