#include "core/poses/large_rank.hpp"

#include <algorithm>
#include <cmath>

#include "core/eigen/decompositions.hpp"
#include "core/numerics/sparse_rank.hpp"
#include "core/poses/least_squares.hpp"
#include "core/poses/typed_verdict.hpp"

namespace jw {

namespace {

constexpr double kRounding = 1e-15;  // as in rank.cpp
// up to ten bodies, singular values are computed as fast as sparse factors
constexpr int kMostDenseColumnsOfVerdict = 60;
// squares of singular values lose twice as many digits: 1e-16 · condition² of the last one
constexpr double kMostConditionOfSquares = 1e4;

/// Groups for dependence: the rows of one joint, or of one driver, stay together.
std::vector<int> groups_in_order(const System& system) {
    std::vector<int> group_of_row;
    int group = -1;
    int last_joint = -1;
    for (int row = 0; row < system.rows(); ++row) {
        const RowOrigin origin = system.origin(row);
        const bool constraint = origin.kind == RowOrigin::Kind::constraint;
        const int joint = constraint ? system.constraints()[at(origin.index)].joint : -1;
        if (!constraint || joint != last_joint) { ++group; }
        group_of_row.push_back(group);
        last_joint = joint;
    }
    return group_of_row;
}

int equations_promised(const System& system) {
    int promised = static_cast<int>(system.drivers().size());
    for (const Constraint& c : system.constraints()) {
        promised += std::min(traits_of(c.role).independent, c.rows());
    }
    return promised;
}

RankReport by_singular_values(const System& system, const SparseRows& jacobian, const VectorX& phi) {
    MatrixX dense(phi.size(), jacobian.columns);
    jacobian.write(dense);
    return analyse_rank(system, dense, phi);
}

}  // namespace

double RankReport::first_value() const {
    if (rank == 0) { return 0.0; }
    return has_spectrum ? singular_values(0) : estimated_first;
}

double RankReport::last_value() const {
    if (rank == 0) { return 0.0; }
    return has_spectrum ? singular_values(rank - 1) : estimated_last;
}

RankReport analyse_large_rank(const System& system, const SparseRows& jacobian, const VectorX& phi) {
    RankReport report;
    report.has_spectrum = false;
    report.rows = static_cast<int>(phi.size());
    report.columns = report.dof = jacobian.columns;
    report.mobility_by_counting = report.columns - equations_promised(system);
    if (report.rows == 0) { return report; }
    const Scaling scaling = scaling_of<OmegaLocal>(system);
    report.residual = scaling.residual_of(phi);
    report.assembled = report.residual <= kAssembledResidual;
    const double error = report.assembled ? kErrorFactor * report.residual : 0.0;
    const SparseRank found = sparse_rank_of(
        jacobian, scaling.row, scaling.column, groups_in_order(system), std::max(kRankThreshold, error));
    if (!found.is_proved()) { return by_singular_values(system, jacobian, phi); }

    report.rank = found.rank;
    report.dof = report.columns - report.rank;
    report.threshold = found.threshold;
    report.estimated_first = found.largest;
    report.estimated_last = found.last;
    report.largest_gap = found.last / std::max(found.next_at_most, kRounding * found.largest);
    report.near_singular = report.rank > 1 && found.last < kNearSingularRatio * found.last_but_one;
    take_typed_verdict(system, report);
    for (const SparseCombination& combination : found.combinations) {
        RedundantRow entry{combination.row, {}, combination.misfit, combination.bound};
        for (std::size_t k = 0; k < combination.rows.size(); ++k) {
            const int row = combination.rows[k];
            entry.terms.push_back(
                {row, combination.coefficients[k] * scaling.row(combination.row) / scaling.row(row)});
        }
        report.redundant_rows.push_back(std::move(entry));
    }
    return report;
}

RankReport analyse_rank_verdict(const System& system, const SparseRows& jacobian, const VectorX& phi) {
    MatrixX dense(phi.size(), jacobian.columns);
    if (jacobian.columns <= kMostDenseColumnsOfVerdict) {
        jacobian.write(dense);
        return analyse_rank(system, dense, phi, RankDetail::verdict);
    }
    RankReport report = analyse_large_rank(system, jacobian, phi);
    const bool is_large = jacobian.columns > kMostColumnsWithSpectrum;
    if (is_large || report.has_spectrum || report.rank == 0) { return report; }
    jacobian.write(dense);
    if (report.estimated_first > kMostConditionOfSquares * report.estimated_last) {
        return analyse_rank(system, dense, phi, RankDetail::verdict);
    }
    const Scaling scaling = scaling_of<OmegaLocal>(system);
    const MatrixX scaled = scaling.row.cwiseInverse().asDiagonal() * dense * scaling.column.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<MatrixX> squares(scaled.transpose() * scaled, Eigen::EigenvaluesOnly);
    const VectorX& values = squares.eigenvalues();  // smallest first
    report.estimated_first = std::sqrt(values(values.size() - 1));
    report.estimated_last = std::sqrt(values(values.size() - report.rank));
    return report;
}

RankReport analyse_rank_of_any_size(
    const System& system, const SparseRows& jacobian, const VectorX& phi, bool spectrum) {
    const bool large = jacobian.columns > kMostColumnsWithSpectrum && !spectrum;
    return large ? analyse_large_rank(system, jacobian, phi) : by_singular_values(system, jacobian, phi);
}

}  // namespace jw
