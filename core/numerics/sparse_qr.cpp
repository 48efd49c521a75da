#include "core/numerics/sparse_qr.hpp"

#include <algorithm>
#include <cmath>

namespace jw {

namespace {

double square(const double* x, int count) {
    double sum = 0.0;
    for (int k = 0; k < count; ++k) { sum += x[k] * x[k]; }
    return sum;
}

/// Applies (1 - τ v vᵀ) with v = (1, tail) to x.
void apply_reflection(const double* tail, double tau, int count, double* x) {
    double sum = x[0];
    for (int k = 1; k < count; ++k) { sum += tail[k] * x[k]; }
    sum *= tau;
    x[0] -= sum;
    for (int k = 1; k < count; ++k) { x[k] -= sum * tail[k]; }
}

}  // namespace

double* SparseQr::column_of(std::size_t f, int column) {
    const auto lines = static_cast<std::size_t>(structure_.fronts()[f].most_lines);
    return values_.data() + numbers_[f].values + static_cast<std::size_t>(column) * lines;
}

const double* SparseQr::column_of(std::size_t f, int column) const {
    const auto lines = static_cast<std::size_t>(structure_.fronts()[f].most_lines);
    return values_.data() + numbers_[f].values + static_cast<std::size_t>(column) * lines;
}

void SparseQr::prepare(const SparseRows& rows) {
    if (structure_.fits(rows)) { return; }
    structure_ = SparseQrStructure(rows, group_of_row_);
    numbers_.assign(structure_.fronts().size(), {});
    std::size_t size = 0;
    int most_lines = 0;
    for (std::size_t f = 0; f < numbers_.size(); ++f) {
        const SparseQrStructure::Front& front = structure_.fronts()[f];
        numbers_[f].values = size;
        size += static_cast<std::size_t>(front.most_lines) * front.rows.size();
        most_lines = std::max(most_lines, front.most_lines);
    }
    values_.resize(size);
    lines_.resize(static_cast<std::size_t>(most_lines));
}

void SparseQr::compute(const SparseRows& rows, const VectorX& row, const VectorX& column, double threshold) {
    prepare(rows);
    threshold_ = threshold;
    largest_ = 0.0;
    for (std::size_t r = 0; r < rows.rows.size(); ++r) {
        double sum = 0.0;
        rows.for_each_entry(
            rows.rows[r], [&](int c, double value) { sum += value * column(c) * value * column(c); });
        largest_ = std::max(largest_, std::sqrt(sum) / row(static_cast<Eigen::Index>(r)));
    }
    pivots_.assign(rows.rows.size(), 0.0);
    slot_of_row_.assign(rows.rows.size(), -1);
    counted_.clear();
    repeating_.clear();
    left_over_ = 0.0;
    for (std::size_t f = 0; f < numbers_.size(); ++f) {
        gather(rows, row, column, f);
        eliminate(f, threshold * largest_);
    }
    left_over_ = std::sqrt(left_over_);
}

/// Collects the lines of a front: its own unknowns, then those that its children could not eliminate.
void SparseQr::gather(const SparseRows& rows, const VectorX& row, const VectorX& column, std::size_t f) {
    const SparseQrStructure::Front& front = structure_.fronts()[f];
    Numbers& numbers = numbers_[f];
    numbers.rows = front.rows;
    numbers.slots.clear();
    numbers.reflections.clear();
    std::fill_n(column_of(f, 0), static_cast<std::size_t>(front.most_lines) * front.rows.size(), 0.0);
    for (const SparseQrStructure::Unknowns& unknowns : front.unknowns) {
        const auto line = static_cast<std::ptrdiff_t>(numbers.slots.size());
        for (int k = 0; k < unknowns.count; ++k) { numbers.slots.push_back(unknowns.first + k); }
        for (const SparseQrStructure::Entry& entry : unknowns.entries) {
            const SparseRow& from = rows.rows[at(entry.row)];
            double* to = column_of(f, entry.column) + line;
            const double* values = entry.side == 2 ? &from.theta : from.block[at(entry.side)].data();
            for (int k = 0; k < unknowns.count; ++k) {
                to[k] = values[k] * column(unknowns.first + k) / row(entry.row);
            }
        }
    }
    for (const int c : front.children) {
        const auto child = static_cast<std::size_t>(c);
        const Numbers& from = numbers_[child];
        const auto line = static_cast<std::ptrdiff_t>(numbers.slots.size());
        const auto first = from.slots.begin() + from.counted;
        numbers.slots.insert(numbers.slots.end(), first, first + from.handed);
        const SparseQrStructure::Front& handing = structure_.fronts()[child];
        for (std::size_t k = 0; k < handing.to_parent.size(); ++k) {
            const int column_there = handing.own + static_cast<int>(k);
            const double* values = column_of(child, column_there) + from.counted;
            double* to = column_of(f, handing.to_parent[k]) + line;
            // compressed lines are zero below their diagonal, where reflections are stored
            const int filled = from.compressed ? std::min(from.handed, static_cast<int>(k) + 1) : from.handed;
            std::copy_n(values, filled, to);
        }
    }
    numbers.lines = static_cast<int>(numbers.slots.size());
}

/// Reflects column `column`, from `line` on, to a single number, and applies the reflection to the columns up
/// to `columns`.
void SparseQr::reflect(std::size_t f, int column, int line, int columns) {
    Numbers& numbers = numbers_[f];
    const int count = numbers.lines - line;
    double* x = column_of(f, column) + line;
    const double tail = square(x + 1, count - 1);
    if (tail == 0.0) { return; }
    const double norm = std::sqrt(x[0] * x[0] + tail);
    const double beta = x[0] > 0.0 ? -norm : norm;
    const double tau = (beta - x[0]) / beta;
    const double scale = 1.0 / (x[0] - beta);
    for (int k = 1; k < count; ++k) { x[k] *= scale; }
    x[0] = beta;
    numbers.reflections.push_back({column, line, tau});
    for (int c = column + 1; c < columns; ++c) { apply_reflection(x, tau, count, column_of(f, c) + line); }
}

void SparseQr::eliminate(std::size_t f, double least) {
    const SparseQrStructure::Front& front = structure_.fronts()[f];
    Numbers& numbers = numbers_[f];
    const int columns = static_cast<int>(front.rows.size());

    // own rows, the one with the largest remainder first
    int line = 0;
    for (; line < front.own; ++line) {
        int best = line;
        double most = -1.0;
        for (int c = line; c < front.own; ++c) {
            const double left = square(column_of(f, c) + line, numbers.lines - line);
            if (left > most) {
                most = left;
                best = c;
            }
        }
        const double pivot = std::sqrt(most);
        if (!(pivot > least)) { break; }
        if (best != line) {
            std::swap_ranges(column_of(f, best), column_of(f, best) + front.most_lines, column_of(f, line));
            std::swap(numbers.rows[at(best)], numbers.rows[at(line)]);
        }
        const int row = numbers.rows[at(line)];
        pivots_[at(row)] = pivot / largest_;
        slot_of_row_[at(row)] = numbers.slots[at(line)];
        counted_.push_back(row);
        reflect(f, line, line, columns);
    }
    numbers.counted = line;
    for (int c = line; c < front.own; ++c) {
        const double left = square(column_of(f, c) + line, numbers.lines - line);
        left_over_ += left;
        pivots_[at(numbers.rows[at(c)])] = largest_ > 0.0 ? std::sqrt(left) / largest_ : 0.0;
        repeating_.push_back(numbers.rows[at(c)]);
    }

    // the parent receives at most as many lines as the front has later columns
    const int later = columns - front.own;
    numbers.compressed = numbers.lines - line > later;
    if (numbers.compressed) {
        for (int k = 0; k < later; ++k) { reflect(f, front.own + k, line + k, columns); }
    }
    numbers.handed = std::min(numbers.lines - line, later);
}

void SparseQr::solve_lower(VectorX& c) const {
    for (std::size_t f = 0; f < numbers_.size(); ++f) {
        const Numbers& numbers = numbers_[f];
        for (int k = 0; k < numbers.counted; ++k) {
            double& z = c(numbers.rows[at(k)]);
            z /= column_of(f, k)[k];
            for (int j = k + 1; j < static_cast<int>(numbers.rows.size()); ++j) {
                c(numbers.rows[at(j)]) -= column_of(f, j)[k] * z;
            }
        }
    }
}

void SparseQr::solve_upper(VectorX& v) const {
    for (std::size_t f = numbers_.size(); f-- > 0;) {
        const Numbers& numbers = numbers_[f];
        for (int k = numbers.counted - 1; k >= 0; --k) {
            double sum = v(numbers.rows[at(k)]);
            for (int j = k + 1; j < static_cast<int>(numbers.rows.size()); ++j) {
                sum -= column_of(f, j)[k] * v(numbers.rows[at(j)]);
            }
            v(numbers.rows[at(k)]) = sum / column_of(f, k)[k];
        }
    }
}

void SparseQr::multiply_by_q(VectorX& y) const {
    for (std::size_t f = numbers_.size(); f-- > 0;) {
        const Numbers& numbers = numbers_[f];
        for (int k = 0; k < numbers.lines; ++k) { lines_[at(k)] = y(numbers.slots[at(k)]); }
        for (auto r = numbers.reflections.rbegin(); r != numbers.reflections.rend(); ++r) {
            apply_reflection(
                column_of(f, r->column) + r->line, r->tau, numbers.lines - r->line, &lines_[at(r->line)]);
        }
        for (int k = 0; k < numbers.lines; ++k) { y(numbers.slots[at(k)]) = lines_[at(k)]; }
    }
}

void SparseQr::multiply_by_q_transposed(VectorX& y) const {
    for (std::size_t f = 0; f < numbers_.size(); ++f) {
        const Numbers& numbers = numbers_[f];
        for (int k = 0; k < numbers.lines; ++k) { lines_[at(k)] = y(numbers.slots[at(k)]); }
        for (const Reflection& r : numbers.reflections) {
            apply_reflection(
                column_of(f, r.column) + r.line, r.tau, numbers.lines - r.line, &lines_[at(r.line)]);
        }
        for (int k = 0; k < numbers.lines; ++k) { y(numbers.slots[at(k)]) = lines_[at(k)]; }
    }
}

/// ‖R_P⁻¹‖_F from the diagonal of (R_Pᵀ R_P)⁻¹, from the last front to the first: a front needs only the part
/// of this inverse on its own later columns, which its parent has.
/// @source Erisman and Tinney, "On computing certain elements of the inverse of a sparse matrix" (1975)
double SparseQr::inverse_norm() const {
    std::vector<MatrixX> inverse(numbers_.size());
    double sum = 0.0;
    for (std::size_t f = numbers_.size(); f-- > 0;) {
        const SparseQrStructure::Front& front = structure_.fronts()[f];
        const Numbers& numbers = numbers_[f];
        const auto own = static_cast<Eigen::Index>(front.own);
        const auto later = static_cast<Eigen::Index>(front.rows.size()) - own;
        const auto counted = static_cast<Eigen::Index>(numbers.counted);
        MatrixX& Z = inverse[f];
        if (Z.size() == 0) { Z.setZero(own + later, own + later); }
        const Eigen::Map<const MatrixX, 0, Eigen::OuterStride<>> values(
            column_of(f, 0), counted, own + later, Eigen::OuterStride<>(front.most_lines));
        // pivot columns: Z_kk = R_kk⁻¹ (1 + R_kU Z_UU R_kUᵀ) R_kk⁻ᵀ, Z_kU = -R_kk⁻¹ R_kU Z_UU
        const auto R = values.leftCols(counted).template triangularView<Eigen::Upper>();
        const MatrixX V = R.solve(MatrixX(values.rightCols(later)));
        const MatrixX VZ = V * Z.bottomRightCorner(later, later);
        const MatrixX inverse_R = R.solve(MatrixX(MatrixX::Identity(counted, counted)));
        Z.topLeftCorner(counted, counted) = inverse_R * inverse_R.transpose() + VZ * V.transpose();
        Z.topRightCorner(own + later, later).topRows(counted) = -VZ;
        Z.bottomLeftCorner(later, own + later).leftCols(counted) = -VZ.transpose();
        sum += Z.topLeftCorner(counted, counted).trace();
        hand_down(f, inverse);
        Z.resize(0, 0);
    }
    return std::sqrt(sum);
}

/// Passes to every child of front `f` the part of the inverse on its later columns.
void SparseQr::hand_down(std::size_t f, std::vector<MatrixX>& inverse) const {
    // columns in the numbering of the structure, before pivoting
    const SparseQrStructure::Front& front = structure_.fronts()[f];
    std::vector<Eigen::Index> place(front.rows.size());
    for (std::size_t k = 0; k < front.rows.size(); ++k) {
        const auto own_end = numbers_[f].rows.begin() + front.own;
        const auto pivoted = std::find(numbers_[f].rows.begin(), own_end, front.rows[k]);
        place[k] = k < at(front.own) ? pivoted - numbers_[f].rows.begin() : static_cast<Eigen::Index>(k);
    }
    for (const int child : front.children) {
        const SparseQrStructure::Front& below = structure_.fronts()[at(child)];
        const auto size = static_cast<Eigen::Index>(below.rows.size());
        MatrixX& Z = inverse[at(child)];
        Z.setZero(size, size);
        for (std::size_t a = 0; a < below.to_parent.size(); ++a) {
            for (std::size_t b = 0; b < below.to_parent.size(); ++b) {
                Z(below.own + static_cast<Eigen::Index>(a), below.own + static_cast<Eigen::Index>(b)) =
                    inverse[f](place[at(below.to_parent[a])], place[at(below.to_parent[b])]);
            }
        }
    }
}

}  // namespace jw
