#include "core/poses/rank.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/eigen/decompositions.hpp"
#include "core/elementary/elementary.hpp"
#include "core/equations/assembler.hpp"
#include "core/numerics/svd.hpp"
#include "core/poses/least_squares.hpp"
#include "core/poses/typed_verdict.hpp"

namespace jw {

namespace {

constexpr double kRounding = 1e-15;  // singular values below this share of the largest are rounding
/// Thresholds, relative to the largest, of negligible terms of a combination; the next one is used if
/// omitting the terms changes the result.
constexpr std::array kNegligibleTerms{1e-9, 1e-12, 0.0};
constexpr double kNotFelt = 1e-12;          // relative to the row that is combined
constexpr double kNegligibleEntry = 1e-12;  // of a free motion: rounding of the elimination
// the eliminations behind combinations and free motions add errors a few times those of the values
constexpr double kRoundings = 10.0;

/// Equations of one joint or one driver: rows that stay together when dependence is determined.
struct Group {
    int first = 0;
    int count = 0;
};

std::vector<Group> groups_of(const System& system) {
    std::vector<Group> groups;
    int last_joint = -1;
    for (int row = 0; row < system.rows(); ++row) {
        const RowOrigin origin = system.origin(row);
        const bool constraint = origin.kind == RowOrigin::Kind::constraint;
        const int joint =
            constraint ? system.constraints()[static_cast<std::size_t>(origin.index)].joint : -1;
        if (!constraint || joint != last_joint) { groups.push_back({row, 0}); }
        ++groups.back().count;
        last_joint = joint;
    }
    return groups;
}

/// Elimination in the order of addition, so that a later joint is reported as redundant with earlier ones;
/// within a group the row with the largest remainder goes first.
class OrderedElimination {
public:
    OrderedElimination(const MatrixX& rows, int rank, double tolerance)
        : rest_(rows), rank_(rank), tolerance_(tolerance) {}

    void add_group(const Group& group) {
        std::vector<int> candidates;
        for (int k = 0; k < group.count; ++k) { candidates.push_back(group.first + k); }
        while (!candidates.empty() && static_cast<int>(independent_.size()) < rank_) {
            const auto best =
                std::ranges::max_element(candidates, {}, [&](int r) { return rest_.row(r).norm(); });
            if (rest_.row(*best).norm() <= tolerance_) { break; }
            accept(*best);
            candidates.erase(best);
        }
        dependent_.insert(dependent_.end(), candidates.begin(), candidates.end());
    }

    /// Adds the best of the remaining rows if the greedy order has found fewer than the singular values
    /// promise.
    void complete() {
        while (static_cast<int>(independent_.size()) < rank_ && !dependent_.empty()) {
            const auto best =
                std::ranges::max_element(dependent_, {}, [&](int r) { return rest_.row(r).norm(); });
            accept(*best);
            dependent_.erase(best);
        }
        std::ranges::sort(dependent_);
        std::ranges::sort(independent_);
    }

    const std::vector<int>& independent() const { return independent_; }
    const std::vector<int>& dependent() const { return dependent_; }

private:
    void accept(int row) {
        const double norm = rest_.row(row).norm();
        independent_.push_back(row);
        if (norm == 0.0) { return; }
        const Eigen::RowVectorXd direction = rest_.row(row) / norm;
        // twice is enough: the second pass removes the rounding of the first
        for (int pass = 0; pass < 2; ++pass) { rest_ -= (rest_ * direction.transpose()) * direction; }
    }

    MatrixX rest_;
    int rank_;
    double tolerance_;
    std::vector<int> independent_;
    std::vector<int> dependent_;
};

/// Coefficients of a row as a combination of the columns of a basis; negligible ones are 0.
VectorX combination_of(
    const MatrixX& basis, const Eigen::ColPivHouseholderQR<MatrixX>& qr, const VectorX& row) {
    VectorX all = qr.solve(row);
    const double size = all.cwiseAbs().maxCoeff();
    const double least = (basis * all - row).norm();
    for (const double share : kNegligibleTerms) {
        VectorX kept = (all.array().abs() > share * size).select(all, 0.0);
        if ((basis * kept - row).norm() <= 2.0 * least + kNotFelt * std::max(1.0, size)) { return kept; }
    }
    return all;
}

/// @param tolerance for the remainder of a row after removal of earlier rows
/// @param vanishing the largest singular value that counts as zero, with its error. A combination with
/// coefficients c is a left null vector of length √(1 + |c|²): it leaves at most `vanishing` times that
std::vector<RedundantRow> redundant_rows_of(
    const System& system, const MatrixX& scaled, const Scaling& scaling, int rank, double tolerance,
    double vanishing) {
    OrderedElimination elimination(scaled, rank, tolerance);
    for (const Group& group : groups_of(system)) { elimination.add_group(group); }
    elimination.complete();

    const std::vector<int>& kept = elimination.independent();
    MatrixX basis(scaled.cols(), static_cast<Eigen::Index>(kept.size()));
    for (std::size_t k = 0; k < kept.size(); ++k) {
        basis.col(static_cast<Eigen::Index>(k)) = scaled.row(kept[k]).transpose();
    }
    // Eigen does not decompose a matrix without columns: rank 0, as for a distance joint at d = 0
    Eigen::ColPivHouseholderQR<MatrixX> qr;
    if (!kept.empty()) { qr.compute(basis); }

    std::vector<RedundantRow> redundant;
    for (const int row : elimination.dependent()) {
        RedundantRow entry{row, {}, 0.0, 0.0};
        // a row that is only rounding means 0 = 0 and does not depend on others
        if (!kept.empty() && scaled.row(row).norm() > tolerance) {
            const VectorX coefficients = combination_of(basis, qr, scaled.row(row).transpose());
            for (std::size_t k = 0; k < kept.size(); ++k) {
                const double c = coefficients(static_cast<Eigen::Index>(k));
                if (c == 0.0) { continue; }
                entry.terms.push_back({kept[k], c * scaling.row(row) / scaling.row(kept[k])});
            }
            // misfit of the reported terms, not of the solution
            entry.misfit = (basis * coefficients - scaled.row(row).transpose()).norm();
            entry.bound = kRoundings * (vanishing + kNotFelt) * elementary::hypot(1.0, coefficients.norm());
        }
        redundant.push_back(std::move(entry));
    }
    return redundant;
}

/// Reduced echelon form of the null space, each vector with its largest entry 1: a free motion of few bodies
/// then appears as one vector (the idle spin of a rod, for example) instead of mixed with all others.
std::vector<FreeMotion> readable_basis(MatrixX basis, const VectorX& column_scale) {
    const Eigen::Index count = basis.cols();
    for (Eigen::Index k = 0; k < count; ++k) {
        Eigen::Index row = 0;
        Eigen::Index column = 0;
        basis.rightCols(count - k).cwiseAbs().maxCoeff(&row, &column);
        basis.col(k).swap(basis.col(k + column));
        basis.col(k) /= basis(row, k);
        for (Eigen::Index other = 0; other < count; ++other) {
            if (other != k) { basis.col(other) -= basis(row, other) * basis.col(k); }
        }
    }
    std::vector<FreeMotion> motions;
    for (Eigen::Index k = 0; k < count; ++k) {
        // in the scene's units: with metres and radians, the size of the scene would decide
        const double negligible = kNegligibleEntry * basis.col(k).cwiseAbs().maxCoeff();
        VectorX motion = (basis.col(k).array().abs() < negligible).select(0.0, basis.col(k));
        motion = motion.cwiseProduct(column_scale).eval();
        Eigen::Index largest = 0;
        motion.cwiseAbs().maxCoeff(&largest);
        motion /= motion(largest);
        motions.push_back(std::move(motion));
    }
    return motions;
}

/// Substitutes a free motion into the equations.
FreeMotionProof proof_of(
    const FreeMotion& motion, const MatrixX& scaled, const VectorX& column_scale, double vanishing) {
    const VectorX v = motion.cwiseQuotient(column_scale);
    const double size = v.norm();
    // entries set to zero were up to this share of the largest
    const double left_out = kNegligibleEntry * scaled.norm();
    return {(scaled * v).norm() / size, kRoundings * (vanishing + left_out)};
}

/// Determines the rank, its margin, and whether it is decided.
void judge(RankReport& report, const Svd& svd) {
    const VectorX& sigma = report.singular_values = svd.sigma;
    report.singular_value_error = svd.error;
    report.sound = svd.sound;
    const double error = report.assembled ? kErrorFactor * report.residual : 0.0;
    // rows have size 1: a matrix that consists of rounding has rank 0
    report.threshold = std::max(kRankThreshold, error) * std::max(1.0, sigma(0));
    report.rank = static_cast<int>(svd.rank(report.threshold));
    report.dof = report.columns - report.rank;

    const Eigen::Index r = report.rank;
    const double floor = kRounding * sigma(0);
    const double last = r > 0 ? sigma(r - 1) : sigma(0);
    const double next = r < sigma.size() ? std::max(sigma(r), floor) : floor;
    report.largest_gap = last / next;
    report.near_singular = r > 1 && sigma(r - 1) < kNearSingularRatio * sigma(r - 2);

    report.pose_error = r > 0 ? error / last : 0.0;
    const bool counts = r == 0 || last - report.pose_error - svd.error > report.threshold;
    const bool vanishes = r == sigma.size() || sigma(r) + svd.error <= report.threshold;
    report.decided = svd.sound && counts && vanishes;
}

}  // namespace

VectorX singular_values_of(const MatrixX& matrix) { return svd_of(matrix).sigma; }

RankReport analyse_rank(
    const System& system, const MatrixX& jacobian, const VectorX& phi, RankDetail detail) {
    RankReport report;
    report.rows = static_cast<int>(jacobian.rows());
    report.columns = static_cast<int>(jacobian.cols());
    int promised = static_cast<int>(system.drivers().size());
    for (const Constraint& c : system.constraints()) {
        promised += std::min(traits_of(c.role).independent, c.rows());
    }
    report.mobility_by_counting = report.columns - promised;
    const Scaling scaling = scaling_of<OmegaLocal>(system);
    if (jacobian.size() == 0) {
        report.dof = report.columns;
        if (report.columns > 0) {
            report.free_motions =
                readable_basis(MatrixX::Identity(report.columns, report.columns), scaling.column);
            report.free_motion_proofs.resize(report.free_motions.size());
        }
        return report;
    }

    const MatrixX scaled = scaling.row.cwiseInverse().asDiagonal() * jacobian * scaling.column.asDiagonal();
    const Svd svd = svd_of(scaled);
    report.residual = scaling.residual_of(phi);
    report.assembled = report.residual <= kAssembledResidual;

    judge(report, svd);
    take_typed_verdict(system, report);
    if (detail == RankDetail::verdict) { return report; }

    const VectorX& sigma = report.singular_values;
    const auto r = static_cast<Eigen::Index>(report.rank);
    const double vanishing = (r < sigma.size() ? sigma(r) : 0.0) + svd.error;
    if (report.redundant() > 0) {
        // between the last singular value that counts and the first that does not
        const double floor = kRounding * sigma(0);
        const double last = r > 0 ? sigma(r - 1) : sigma(0);
        const double next = r < sigma.size() ? std::max(sigma(r), floor) : floor;
        report.redundant_rows =
            redundant_rows_of(system, scaled, scaling, report.rank, std::sqrt(last * next), vanishing);
    }
    if (report.dof > 0) {
        report.free_motions = readable_basis(svd.V.rightCols(report.dof), scaling.column);
        for (const FreeMotion& motion : report.free_motions) {
            report.free_motion_proofs.push_back(proof_of(motion, scaled, scaling.column, vanishing));
        }
    }
    return report;
}

std::vector<int> removable_rows(const RankReport& report) {
    std::vector<int> rows;
    for (const RedundantRow& redundant : report.redundant_rows) {
        rows.push_back(redundant.row);
        for (const RedundantRow::Term& term : redundant.terms) { rows.push_back(term.row); }
    }
    std::ranges::sort(rows);
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    return rows;
}

}  // namespace jw
