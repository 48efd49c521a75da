#include "core/kinematics/proof/part_recorder.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/eigen/decompositions.hpp"

namespace jw {

namespace {

// Growth of the inverse beyond which rows are chosen again: one choice connects the steps of a motion.
constexpr double kMuchWeaker = 1.5;
// A bound of a path by its coefficients about the middle is four times the maximum of t²(1 - t)².
constexpr double kBoundOfPath = 4.0;
// Poses are doubles: equations hold up to a few roundings.
constexpr double kRounding = 0x1p-51;
// A tube is wider than its image by this factor, so that intervals have room around estimates from samples.
constexpr double kRoom = 2.0;
constexpr double kLeastRoom = 1.5;
// Least and largest ρ, in units of the coordinates.
constexpr double kLeastTube = 1e-13;
constexpr double kLargestTube = 0.05;
constexpr int kMostEnlargements = 60;
// Deviation of a row from its tangent: about 2|s| δ² at a distance δ of the p of both bodies.
constexpr double kCurvature = 4.0;

/// Largest sum of absolute values in a row.
double row_sum(const auto& block) { return block.cwiseAbs().rowwise().sum().maxCoeff(); }

}  // namespace

std::vector<ProofRow> rows_of(const std::vector<ProvedEquation>& equations, const std::vector<int>& chosen) {
    std::vector<ProofRow> rows;
    for (const int e : chosen) {
        const ProvedEquation& equation = equations[at(e)];
        for (int k = 0, found = 0; found < equation.rows; ++k) {
            if (!equation.has_row(k)) { continue; }
            rows.push_back({e, k});
            ++found;
        }
    }
    return rows;
}

MatrixX columns_of(
    const ProvedStep& step, const PathSample& sample, const std::vector<int>& which,
    const std::vector<int>& coordinates) {
    std::vector<int> first(step.table().all().size(), -1);
    int columns = 0;
    for (const int k : coordinates) {
        first[at(k)] = columns;
        columns += step.table().all()[at(k)].size;
    }
    int rows = 0;
    for (const int e : which) { rows += step.equations()[at(e)].rows; }
    MatrixX all = MatrixX::Zero(rows, columns);
    int row = 0;
    for (const int e : which) {
        for_each_block(step.blocks(e), sample.jacobians[at(e)], [&](int k, const MatrixX& block) {
            if (first[at(k)] < 0) { return; }
            all.block(row, first[at(k)], block.rows(), block.cols()) += block;
        });
        row += step.equations()[at(e)].rows;
    }
    return all;
}

PartRecorder::PartRecorder(Part part, const ProvedStep& step)
    : part_(std::move(part)), step_(&step), rows_(rows_of(step.equations(), part_.equations)) {}

MatrixX PartRecorder::columns_at(const PathSample& sample, const std::vector<int>& coordinates) const {
    return columns_of(*step_, sample, part_.equations, coordinates);
}

MatrixX PartRecorder::chosen_of(const MatrixX& rows) const {
    MatrixX chosen = MatrixX::Zero(part_.columns, rows.cols());
    for (std::size_t k = 0; k < chosen_.size(); ++k) {
        chosen.row(static_cast<Eigen::Index>(k)) = rows.row(chosen_[k]);
    }
    return chosen;
}

int PartRecorder::first_of(std::size_t unknown) const {
    int first = 0;
    for (std::size_t u = 0; u < unknown; ++u) { first += size_of(part_.unknowns[u]); }
    return first;
}

/// Inverts the rows chosen before, or the most independent ones. Separate rows fix the motions that these
/// rows leave free.
bool PartRecorder::choose_and_invert(const MatrixX& rows) {
    const auto invert = [&] {
        MatrixX square = chosen_of(rows);
        square.bottomRows(kept_.rows()) = kept_;
        inverse_ = inverse_of(square);
        return inverse_.norm();
    };
    const bool is_square = part_.rank == part_.columns;
    if (is_square && !chosen_.empty() && invert() <= kMuchWeaker * size_of_inverse_) { return true; }
    Eigen::ColPivHouseholderQR<MatrixX> qr(rows.transpose());
    qr.setThreshold(kIndependent);
    if (qr.rank() != part_.rank) { return false; }
    const auto& order = qr.colsPermutation().indices();
    chosen_.assign(order.begin(), order.begin() + part_.rank);
    MatrixX q = MatrixX::Identity(part_.columns, part_.columns);
    multiply_by_q(qr.householderQ(), q);
    kept_ = q.rightCols(part_.free_columns()).transpose();
    size_of_inverse_ = invert();
    return std::isfinite(size_of_inverse_);
}

/// Estimates K and α by blocks, in the maximum norm.
void PartRecorder::estimate(const std::vector<PathSample>& samples, const std::vector<double>& errors) {
    const auto unknowns = static_cast<Eigen::Index>(part_.unknowns.size());
    K_.setZero(unknowns, unknowns);
    VectorX phi = VectorX::Zero(part_.columns);
    VectorX from_inputs = VectorX::Zero(unknowns);
    for (const PathSample& sample : samples) {
        MatrixX square = chosen_of(columns_at(sample, part_.unknowns));
        square.bottomRows(kept_.rows()) = kept_;
        const MatrixX defect = MatrixX::Identity(part_.columns, part_.columns) - inverse_ * square;
        const MatrixX passed_on = inverse_ * chosen_of(columns_at(sample, part_.inputs));
        for (Eigen::Index u = 0; u < unknowns; ++u) {
            const int size = size_of(part_.unknowns[at(u)]);
            const int row = first_of(at(u));
            for (Eigen::Index c = 0; c < unknowns; ++c) {
                const auto block = defect.block(row, first_of(at(c)), size, size_of(part_.unknowns[at(c)]));
                K_(u, c) = std::max(K_(u, c), row_sum(block));
            }
            double sum = 0.0;
            int column = 0;
            for (const int k : part_.inputs) {
                sum += errors[at(k)] * row_sum(passed_on.block(row, column, size, size_of(k)));
                column += size_of(k);
            }
            from_inputs(u) = std::max(from_inputs(u), sum);
        }
        for (std::size_t k = 0; k < chosen_.size(); ++k) {
            double& largest = phi(static_cast<Eigen::Index>(k));
            largest = std::max(largest, sample.phi[at(rows_[at(chosen_[k])].equation)] + kRounding);
        }
    }
    const VectorX all = kBoundOfPath * (inverse_.cwiseAbs() * phi);
    alpha_ = from_inputs;
    size_of_M_.resize(unknowns);
    for (Eigen::Index u = 0; u < unknowns; ++u) {
        const int size = size_of(part_.unknowns[at(u)]);
        alpha_(u) += all.segment(first_of(at(u)), size).maxCoeff();
        size_of_M_(u) = row_sum(inverse_.middleRows(first_of(at(u)), size));
    }
}

/// Image of a tube under x - M Φ.
VectorX PartRecorder::image_of(const VectorX& radius) const {
    return alpha_ + K_ * radius + kCurvature * radius.maxCoeff() * radius.maxCoeff() * size_of_M_;
}

bool PartRecorder::find_radius() {
    radius_ = VectorX::Constant(alpha_.size(), kLeastTube);
    for (int n = 0; n < kMostEnlargements; ++n) {
        const VectorX image = image_of(radius_);
        if ((kLeastRoom * image.array() <= radius_.array()).all()) { return true; }
        radius_ = radius_.cwiseMax(kRoom * image);
        if (!(radius_.maxCoeff() <= kLargestTube)) { return false; }
    }
    return false;
}

bool PartRecorder::record(
    const std::vector<PathSample>& samples, std::vector<double>& errors, PartRecord& record) {
    if (!choose_and_invert(columns_at(samples[samples.size() / 2], part_.unknowns))) { return false; }
    estimate(samples, errors);
    if (!find_radius()) { return false; }
    const VectorX image = image_of(radius_);
    for (std::size_t u = 0; u < part_.unknowns.size(); ++u) {
        errors[at(part_.unknowns[u])] = image(static_cast<Eigen::Index>(u));
    }
    write(record);
    return true;
}

/// Writes without the scales of rows and columns.
void PartRecorder::write(PartRecord& record) const {
    record.unknowns = part_.unknowns;
    record.kept = kept_;
    record.inverse = inverse_;
    record.radius = radius_;
    record.rows.clear();
    for (std::size_t k = 0; k < chosen_.size(); ++k) {
        record.rows.push_back(rows_[at(chosen_[k])]);
        record.inverse.col(static_cast<Eigen::Index>(k)) /=
            step_->equations()[at(record.rows.back().equation)].unit;
    }
    for (std::size_t u = 0; u < part_.unknowns.size(); ++u) {
        const Coordinates& c = step_->table().all()[at(part_.unknowns[u])];
        record.inverse.middleRows(first_of(u), c.size) *= c.scale;
        record.kept.middleCols(first_of(u), c.size) /= c.scale;
        record.radius(static_cast<Eigen::Index>(u)) *= c.scale;
    }
}

}  // namespace jw
