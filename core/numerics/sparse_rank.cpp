#include "core/numerics/sparse_rank.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/eigen/decompositions.hpp"
#include "core/elementary/elementary.hpp"

namespace jw {

namespace {

// relative to the largest coefficient, as in rank.cpp; the next one is used if omitting the terms has an
// effect
constexpr std::array kNegligibleTerms{1e-9, 1e-12, 0.0};
// enough iterations to know the largest value to 1 %, and to separate small values that differ by a factor of
// a thousand
constexpr int kPowerSteps = 30;
constexpr int kInverseSteps = 20;
// backward error of reflections: a few roundings per column, in fronts of some tens of columns
constexpr double kRounding = 100.0 * std::numeric_limits<double>::epsilon();

/// Start vector without the symmetries of a mechanism: no two entries are equal.
VectorX any_vector(Eigen::Index size, double phase) {
    VectorX v(size);
    for (Eigen::Index k = 0; k < size; ++k) { v(k) = elementary::cos(phase + 2.4 * static_cast<double>(k)); }
    return v.normalized();
}

double largest_singular_value(const SparseRows& rows, const VectorX& row, const VectorX& column) {
    if (rows.rows.empty() || rows.columns == 0) { return 0.0; }
    VectorX x = any_vector(rows.columns, 1.0);
    VectorX image;
    double value = 0.0;
    for (int k = 0; k < kPowerSteps; ++k) {
        rows.multiply(x.cwiseProduct(column), image);
        image = image.cwiseQuotient(row);
        value = image.norm();
        x = rows.transposed_times(image.cwiseQuotient(row)).cwiseProduct(column);
        const double norm = x.norm();
        if (norm == 0.0) { return 0.0; }
        x /= norm;
    }
    return value;
}

/// Computes (R_P R_Pᵀ)⁻¹ v, for v on the independent rows.
VectorX inverse_product(const SparseQr& qr, const VectorX& v) {
    VectorX out = v;
    qr.solve_upper(out);
    qr.solve_lower(out);
    for (const int row : qr.repeating()) { out(row) = 0.0; }
    return out;
}

/// Two smallest singular values of R_P, by inverse iteration on three vectors.
std::array<double, 2> smallest_singular_values(const SparseQr& qr, Eigen::Index rows) {
    const Eigen::Index count = std::min<Eigen::Index>(3, qr.rank());
    MatrixX basis(rows, count);
    for (Eigen::Index k = 0; k < count; ++k) { basis.col(k) = any_vector(rows, static_cast<double>(k)); }
    for (const int row : qr.repeating()) { basis.row(row).setZero(); }
    std::array<double, 2> values{0.0, 0.0};
    for (int step = 0; step < kInverseSteps; ++step) {
        const MatrixX Q = orthonormal_columns(basis);
        for (Eigen::Index k = 0; k < count; ++k) { basis.col(k) = inverse_product(qr, Q.col(k)); }
        VectorX sizes = basis.colwise().norm();
        std::ranges::sort(sizes, std::greater<>());
        for (std::size_t k = 0; k < 2 && static_cast<Eigen::Index>(k) < count; ++k) {
            values[k] = 1.0 / std::sqrt(sizes(static_cast<Eigen::Index>(k)));
        }
    }
    return values;
}

SparseCombination combination_of(
    const SparseQr& qr, const SparseRows& rows, const VectorX& row, const VectorX& column, int repeating,
    double next_at_most) {
    VectorX v = VectorX::Zero(static_cast<Eigen::Index>(rows.rows.size()));
    v(repeating) = -1.0;
    qr.solve_upper(v);
    v(repeating) = 0.0;
    for (const int other : qr.repeating()) { v(other) = 0.0; }

    const auto misfit_of = [&](const VectorX& terms) {
        VectorX difference = rows.transposed_times(terms.cwiseQuotient(row));
        rows.for_each_entry(
            rows.rows[at(repeating)], [&](int c, double value) { difference(c) -= value / row(repeating); });
        return difference.cwiseProduct(column).norm();
    };
    // a left null vector of this length leaves a misfit of at most σ_(r+1) times its length
    const double bound = next_at_most * std::sqrt(1.0 + v.squaredNorm());
    const double size = v.cwiseAbs().maxCoeff();
    VectorX terms;
    for (const double share : kNegligibleTerms) {
        terms = (v.array().abs() > share * size).select(v, 0.0);
        if (misfit_of(terms) <= bound) { break; }
    }
    SparseCombination combination{repeating, {}, {}, misfit_of(terms), bound};
    for (Eigen::Index k = 0; k < terms.size(); ++k) {
        if (terms(k) == 0.0) { continue; }
        combination.rows.push_back(static_cast<int>(k));
        combination.coefficients.push_back(terms(k));
    }
    return combination;
}

double scaled_size(const SparseRows& rows, const VectorX& row, const VectorX& column, int r) {
    double sum = 0.0;
    rows.for_each_entry(
        rows.rows[at(r)], [&](int c, double value) { sum += value * column(c) * value * column(c); });
    return std::sqrt(sum) / row(r);
}

}  // namespace

SparseRank sparse_rank_of(
    const SparseRows& rows, const VectorX& row, const VectorX& column, std::vector<int> group_of_row,
    double relative_threshold) {
    SparseRank result;
    result.largest = largest_singular_value(rows, row, column);
    result.threshold = relative_threshold * std::max(1.0, result.largest);
    double largest_row = 0.0;
    for (int r = 0; r < static_cast<int>(rows.rows.size()); ++r) {
        largest_row = std::max(largest_row, scaled_size(rows, row, column, r));
    }
    SparseQr qr(std::move(group_of_row));
    qr.compute(rows, row, column, largest_row > 0.0 ? result.threshold / largest_row : 0.0);

    result.rank = qr.rank();
    const double rounding = kRounding * largest_row * std::sqrt(static_cast<double>(rows.rows.size()));
    result.next_at_most = qr.left_over() + rounding;
    if (result.rank > 0) {
        result.last_at_least = 1.0 / qr.inverse_norm() - rounding;
        const auto smallest = smallest_singular_values(qr, static_cast<Eigen::Index>(rows.rows.size()));
        result.last = smallest[0];
        result.last_but_one = result.rank > 1 ? smallest[1] : 0.0;
    }
    result.repeating = qr.repeating();
    std::ranges::sort(result.repeating);
    for (const int repeating : result.repeating) {
        // a row that is only rounding means 0 = 0 and does not depend on others
        if (result.rank == 0 || scaled_size(rows, row, column, repeating) <= result.threshold) {
            result.combinations.push_back({repeating, {}, {}});
        } else {
            result.combinations.push_back(
                combination_of(qr, rows, row, column, repeating, result.next_at_most));
        }
    }
    return result;
}

}  // namespace jw
