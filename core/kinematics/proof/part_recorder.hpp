#pragma once

#include <vector>

#include "core/kinematics/proof/proof_record.hpp"
#include "core/kinematics/proof/proved_step.hpp"

/// Preconditioner and tube of a part over a step, for programs that check them with their own bounds.
namespace jw {

/// The equations at one point of the path x̂: scaled as in StepEnd and EquationJacobian.
struct PathSample {
    std::vector<double> phi;
    std::vector<EquationJacobian> jacobians;
};

/// Rows of the equations `which`, in their order.
std::vector<ProofRow> rows_of(const std::vector<ProvedEquation>& equations, const std::vector<int>& which);
/// Jacobian of the equations `which` in the columns of `coordinates`, scaled.
MatrixX columns_of(
    const ProvedStep& step, const PathSample& sample, const std::vector<int>& which,
    const std::vector<int>& coordinates);

class PartRecorder {
public:
    /// @param step must outlive this
    PartRecorder(Part part, const ProvedStep& step);

    const Part& part() const { return part_; }
    /// Writes the proof of a step into `record`. Estimates from samples need no proof here: the program that
    /// checks the tube bounds them.
    /// @param samples  points of the step, both ends and the middle among them
    /// @param errors   per coordinate: bound of |x - x̂|, known for earlier parts; set for the unknowns
    /// @return false if the step is too long
    bool record(const std::vector<PathSample>& samples, std::vector<double>& errors, PartRecord& record);

private:
    MatrixX columns_at(const PathSample& sample, const std::vector<int>& coordinates) const;
    bool choose_and_invert(const MatrixX& rows);
    void estimate(const std::vector<PathSample>& samples, const std::vector<double>& errors);
    VectorX image_of(const VectorX& radius) const;
    bool find_radius();
    MatrixX chosen_of(const MatrixX& rows) const;
    int first_of(std::size_t unknown) const;
    int size_of(int coordinate) const { return step_->table().all()[at(coordinate)].size; }
    void write(PartRecord& record) const;

    Part part_;
    const ProvedStep* step_;
    std::vector<ProofRow> rows_;  ///< of the part
    std::vector<int> chosen_;     ///< indices in `rows_`
    double size_of_inverse_ = 0.0;
    MatrixX kept_;
    MatrixX inverse_;
    MatrixX K_;
    VectorX alpha_;
    VectorX size_of_M_;  ///< per unknown: largest sum of a row
    VectorX radius_;
};

/// Rank of all equations at a pose.
RankRecord record_rank(const ProvedStep& step, const PathSample& sample);

}  // namespace jw
