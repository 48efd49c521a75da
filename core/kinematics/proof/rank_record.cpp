#include <algorithm>
#include <numeric>
#include <utility>

#include "core/eigen/decompositions.hpp"
#include "core/kinematics/proof/part_recorder.hpp"
#include "core/kinematics/proof/proved_part.hpp"

namespace jw {

namespace {

std::vector<int> all_of(std::size_t count) {
    std::vector<int> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

/// Orders the most independent rows first. @return their number
Eigen::Index order_rows(const MatrixX& rows, std::vector<int>& order) {
    Eigen::ColPivHouseholderQR<MatrixX> qr(rows.transpose());
    qr.setThreshold(kIndependent);
    order.assign(qr.colsPermutation().indices().begin(), qr.colsPermutation().indices().end());
    return qr.rank();
}

/// Rows and columns of all equations, scaled, with their divisors.
class RankRecorder {
public:
    RankRecorder(const ProvedStep& step, const PathSample& sample)
        : rows_(rows_of(step.equations(), all_of(step.equations().size()))),
          J_(columns_of(step, sample, all_of(step.equations().size()), all_of(step.table().all().size()))) {
        for (const ProofRow& row : rows_) { units_.push_back(step.equations()[at(row.equation)].unit); }
        for (const Coordinates& c : step.table().all()) {
            scales_.insert(scales_.end(), at(c.size), c.scale);
        }
    }

    RankRecord record() {
        RankRecord record;
        std::vector<int> order;
        const Eigen::Index rank = order_rows(J_, order);
        independent_.resize(rank, J_.cols());
        for (Eigen::Index k = 0; k < rank; ++k) { independent_.row(k) = J_.row(order[at(k)]); }
        order_rows(independent_.transpose(), record.columns);
        record.columns.resize(at(rank));
        MatrixX minor(rank, rank);
        for (Eigen::Index k = 0; k < rank; ++k) { minor.col(k) = independent_.col(record.columns[at(k)]); }
        inverse_ = inverse_of(minor);
        record.inverse = inverse_;
        for (Eigen::Index k = 0; k < rank; ++k) {
            record.rows.push_back(rows_[at(order[at(k)])]);
            record.inverse.col(k) /= units_[at(order[at(k)])];
            record.inverse.row(k) *= scales_[at(record.columns[at(k)])];
        }
        for (std::size_t k = at(rank); k < order.size(); ++k) {
            record.repeated.push_back(combination_of(order[k], order, record.columns));
        }
        return record;
    }

private:
    RankRecord::Repeated combination_of(
        int row, const std::vector<int>& order, const std::vector<int>& columns) const {
        VectorX of_minor(inverse_.rows());
        for (std::size_t c = 0; c < columns.size(); ++c) {
            of_minor(static_cast<Eigen::Index>(c)) = J_(row, columns[c]);
        }
        VectorX combination = inverse_.transpose() * of_minor;
        const VectorX own = J_.row(row).transpose();
        const VectorX off =
            (own - independent_.transpose() * combination).cwiseAbs() +
            kRoundingOfRow * (own.cwiseAbs() + independent_.transpose().cwiseAbs() * combination.cwiseAbs());
        double misfit = kRoundingOfRow;
        for (Eigen::Index c = 0; c < off.size(); ++c) {
            misfit = std::max(misfit, units_[at(row)] * off(c) / scales_[at(c)]);
        }
        for (Eigen::Index n = 0; n < combination.size(); ++n) {
            combination(n) *= units_[at(row)] / units_[at(order[at(n)])];
        }
        return {rows_[at(row)], std::move(combination), misfit};
    }

    std::vector<ProofRow> rows_;
    MatrixX J_;
    std::vector<double> units_;
    std::vector<double> scales_;
    MatrixX independent_;  ///< rows of J_
    MatrixX inverse_;      ///< inverse of a minor of these
};

}  // namespace

RankRecord record_rank(const ProvedStep& step, const PathSample& sample) {
    int columns = 0;
    for (const Coordinates& c : step.table().all()) { columns += c.size; }
    return columns <= kMostProvedColumns ? RankRecorder(step, sample).record() : RankRecord{};
}

}  // namespace jw
