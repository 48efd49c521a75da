#include "core/motion/block/block_equations.hpp"

#include <bit>
#include <cmath>

#include "core/equations/constraint_rounding.hpp"

/// Projection onto the constraints, and choice of rows, of the block equations.
namespace jw {

namespace {

/// Size below which a row counts as zero: a row of a sound joint has size 1 or, for directions, 1 / extent; a
/// smaller row is rounding.
constexpr double kVanishes = 1e-12;
/// Contraction of an iteration up to which an earlier factorisation is good enough.
constexpr double kFastConvergence = 1e-2;

double vanishing_size(double extent) {
    const double size = kVanishes * std::min(1.0, 1.0 / extent);
    return size * size;
}

/// Rows of a node, one bit each.
struct ChoiceOfRows {
    unsigned kept = 0;
    unsigned doubtful = 0;  ///< too little remains of these rows, but more than of redundant ones
};

/// Rows of a block of Φq Φqᵀ, reduced by the nodes before it, whose remainder exceeds the share `least`:
/// diagonal pivoting.
template <int B>
ChoiceOfRows independent_rows_of(
    const double* block, const double* row_size, unsigned candidates, double least) {
    double a[B * B];
    std::copy(block, block + B * B, a);
    ChoiceOfRows out;
    for (;;) {
        int best = -1;
        double best_ratio = least;
        out.doubtful = 0;
        for (int row = 0; row < B; ++row) {
            const bool open = (((candidates & ~out.kept) >> row) & 1U) != 0;
            const double ratio = a[row * B + row] / row_size[row];
            if (open && ratio > kRepeats) { out.doubtful |= 1U << row; }
            if (open && ratio > best_ratio) {
                best = row;
                best_ratio = ratio;
            }
        }
        if (best < 0) { return out; }
        out.kept |= 1U << best;
        for (int row = 0; row < B; ++row) {
            if (row == best) { continue; }
            const double factor = a[row * B + best] / a[best * B + best];
            for (int k = 0; k < B; ++k) { a[row * B + k] -= factor * a[best * B + k]; }
        }
    }
}

}  // namespace

template <int B>
double BlockEquations<B>::project(double t, double* y) {
    for (std::size_t m = 0; m < moving_.size(); ++m) { vec4(body_numbers(y, m) + 3).normalize(); }
    double before = 0.0;
    double last = std::numeric_limits<double>::infinity();
    bool factored = false;
    for (int round = 0; round < kMostRounds; ++round) {
        set_bodies(Content::jacobian, y);
        evaluate_links(Content::jacobian, t);
        const double worst = largest(phi_, true);
        if (round == 0) { before = worst; }
        if (is_at_rounding(worst, last)) { break; }
        const bool slow = worst > kFastConvergence * last;
        last = worst;
        // near rounding, the factorisation of the previous iteration is as good as a new one
        if (!factored || (slow && worst > kNearlyExact)) {
            factor_in_metric();
            factored = true;
        }
        set_lambda(phi_);
        for (double& l : lambda_) { l = -l; }
        matrix_.solve(lambda_.data());
        std::fill(six_.begin(), six_.end(), 0.0);
        add_reactions(lambda_.data(), six_.data());
        displace(y, six_.data(), moving_.size());
    }
    if (!factored) { factor_in_metric(); }
    project_velocities(y);
    return before;
}

template <int B>
double BlockEquations<B>::largest(const std::vector<double>& numbers, bool kept) const {
    double worst = 0.0;
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        for (int row = 0; row < nodes_[n].link.rows; ++row) {
            const std::size_t k = n * B + at(row);
            if (has(nodes_[n].kept, row) == kept) {
                worst = std::max(worst, std::abs(numbers[k]) * inverse_unit_[k]);
            }
        }
    }
    return worst;
}

template <int B>
double BlockEquations<B>::size_of_six() const {
    double size = 0.0;
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        const double* v = &six_[6 * m];
        size = std::max({size, vec3(v).norm() / extent_, vec3(v + 3).norm()});
    }
    return size;
}

/// Every iteration multiplies the residual by the relative error of the factors, which are of a nearby pose.
template <int B>
void BlockEquations<B>::meet(const std::vector<double>& right, double size) {
    double last = std::numeric_limits<double>::infinity();
    for (int round = 0; round < kMostRounds; ++round) {
        set_lambda(right);
        subtract_products(six_.data(), lambda_.data());
        const double worst = largest(lambda_, true);
        // converged to rounding, as for positions
        if (round > 0 && (worst <= kRoundingOnly * size || worst > 0.5 * last)) { break; }
        last = worst;
        matrix_.solve(lambda_.data());
        add_reactions(lambda_.data(), six_.data());
    }
}

template <int B>
void BlockEquations<B>::project_velocities(double* y) {
    for (std::size_t m = 0; m < moving_.size(); ++m) { std::copy_n(body_numbers(y, m) + 7, 6, &six_[6 * m]); }
    meet(nu_, size_of_six());
    for (std::size_t m = 0; m < moving_.size(); ++m) { std::copy_n(&six_[6 * m], 6, body_numbers(y, m) + 7); }
}

/// Removes the rows that are not kept from the matrix, just before the block of their node is factored.
template <int B>
void BlockEquations<B>::strike_rows(int n, double* diagonal) {
    for (int row = 0; row < B; ++row) {
        if (has(nodes_[at(n)].kept, row)) { continue; }
        for (int k = 0; k < B; ++k) { diagonal[row * B + k] = diagonal[k * B + row] = 0.0; }
        diagonal[row * B + row] = row_size_[at(n) * B + at(row)] = 1.0;
        for (const auto& upper : structure_.pivots()[at(structure_.position(n))].uppers) {
            double* x = matrix_.block(upper.block) + row * B;
            std::fill(x, x + B, 0.0);
        }
    }
}

/// Keeps rows with a pivot above `least`. The pivots of the `doubtful` rows, after removal of all kept rows,
/// are smaller.
/// @return number of kept rows
template <int B>
int BlockEquations<B>::keep_rows_beyond(double least, std::vector<RowOfNode>& doubtful) {
    doubtful.clear();
    for (Node& node : nodes_) { node.kept = (1U << node.link.rows) - 1U; }
    form_matrix();
    const double vanishing = vanishing_size(extent_);
    int count = 0;
    matrix_.factor([&](int n, double* diagonal) {
        Node& node = nodes_[at(n)];
        for (int row = 0; row < B; ++row) {
            if (row_size_[at(n) * B + at(row)] < vanishing) { node.kept &= ~(1U << row); }
        }
        const ChoiceOfRows choice = independent_rows_of<B>(diagonal, &row_size_[at(n) * B], node.kept, least);
        node.kept = choice.kept;
        for (int row = 0; row < B; ++row) {
            if (has(choice.doubtful, row)) { doubtful.push_back({at(n), row}); }
        }
        count += std::popcount(node.kept);
        strike_rows(n, diagonal);
    });
    return count;
}

/// Factors the matrix of the kept rows.
/// @param all Jᵀ of every side, with all rows
template <int B>
void BlockEquations<B>::factor_kept_rows(const std::vector<double>& all) {
    j_ = all;
    for (std::size_t k = 0; k < j_.size(); ++k) {
        const std::size_t node = k / (2 * static_cast<std::size_t>(kSide));
        if (!has(nodes_[node].kept, static_cast<int>(k) % B)) { j_[k] = 0.0; }
    }
    weigh(Metric::geometry);
    form_matrix();
    matrix_.factor();
}

/// Projects `six_` onto the motions that the kept rows leave free, in the metric of the last factorisation.
template <int B>
void BlockEquations<B>::take_out_rows() {
    std::ranges::fill(lambda_, 0.0);
    subtract_products(six_.data(), lambda_.data());
    matrix_.solve(lambda_.data());
    add_reactions(lambda_.data(), six_.data());
}

/// Product of a row of `all` with six numbers per body.
template <int B>
double BlockEquations<B>::along(const std::vector<double>& all, const RowOfNode& row, const double* x) const {
    double sum = 0.0;
    for (const int body : {0, 1}) {
        const int moving = body == 0 ? nodes_[row.node].moving_i : nodes_[row.node].moving_j;
        const double* j = &all[side_at(2 * static_cast<int>(row.node) + body) + at(row.row)];
        for (std::size_t k = 0; moving >= 0 && k < 6; ++k) { sum += j[k * B] * x[6 * at(moving) + k]; }
    }
    return sum;
}

/// Sets `six_` to the remainder of a row after removal of all kept rows, in the metric of geometry.
/// @return square of the remainder divided by that of the row; 0 for a zero row
template <int B>
double BlockEquations<B>::what_is_left_of(const std::vector<double>& all, RowOfNode& row) {
    std::ranges::fill(six_, 0.0);
    const double per_square = 1.0 / (extent_ * extent_);
    for (const int body : {0, 1}) {
        const int moving = body == 0 ? nodes_[row.node].moving_i : nodes_[row.node].moving_j;
        const double* j = &all[side_at(2 * static_cast<int>(row.node) + body) + at(row.row)];
        for (std::size_t k = 0; moving >= 0 && k < 6; ++k) {
            six_[6 * at(moving) + k] = (k < 3 ? 1.0 : per_square) * j[k * B];
        }
    }
    row.square = along(all, row, six_.data());
    if (row.square < vanishing_size(extent_)) { return 0.0; }
    take_out_rows();
    return along(all, row, six_.data()) / row.square;
}

/// Adds rows that are independent of the kept ones, the one with the largest remainder first: Cholesky's
/// method with pivoting on the remainders.
template <int B>
void BlockEquations<B>::keep_what_is_left(
    const std::vector<double>& all, const std::vector<RowOfNode>& doubtful) {
    std::vector<RowOfNode> rows;
    for (RowOfNode row : doubtful) {
        if (what_is_left_of(all, row) > kRepeats) { rows.push_back(row); }
    }
    const auto count = static_cast<Eigen::Index>(rows.size());
    MatrixX products(count, count);
    for (Eigen::Index c = 0; c < count; ++c) {
        what_is_left_of(all, rows[at(c)]);
        for (Eigen::Index r = 0; r < count; ++r) {
            products(r, c) =
                along(all, rows[at(r)], six_.data()) / std::sqrt(rows[at(r)].square * rows[at(c)].square);
        }
    }
    MatrixX factor(count, count);
    VectorX left = products.diagonal();
    for (Eigen::Index rank = 0; rank < count; ++rank) {
        Eigen::Index best = 0;
        if (!(left.maxCoeff(&best) > kRepeats)) { return; }
        nodes_[rows[at(best)].node].kept |= 1U << rows[at(best)].row;
        factor.col(rank) = products.col(best);
        factor.col(rank) -= factor.leftCols(rank) * factor.row(best).head(rank).transpose();
        factor.col(rank) /= std::sqrt(left(best));
        left -= factor.col(rank).cwiseAbs2();
        left(best) = 0.0;
    }
}

/// Chooses the kept rows. A joint may have a row that nearly depends on earlier ones although a row of
/// another joint would be clearly independent; and after such a row, rounding looks like an independent row.
/// Therefore the surely independent rows come first, and the remainder after removal of all of them decides
/// about the others.
template <int B>
void BlockEquations<B>::keep_independent_rows() {
    std::vector<RowOfNode> doubtful;
    const int rank = keep_rows_beyond(kRepeats, doubtful);
    if (smallest_pivot() > kSurelyIndependent) { return; }
    if (keep_rows_beyond(kSurelyIndependent, doubtful) == rank) { return; }
    const std::vector<double> all = j_;
    factor_kept_rows(all);
    keep_what_is_left(all, doubtful);
    factor_kept_rows(all);
}

/// Computes the units of all equations from the sizes of their rows.
template <int B>
void BlockEquations<B>::measure_units() {
    weigh(Metric::geometry);
    form_matrix();
    for (std::size_t k = 0; k < row_size_.size(); ++k) {
        const double size = extent_ * std::sqrt(row_size_[k]);
        inverse_unit_[k] = size > 0.0 ? 1.0 / size : 1.0;
    }
}

/// Computes Jacobians and units of all rows, and marks all rows as kept.
template <int B>
void BlockEquations<B>::look_at_all_rows(double t, const double* y) {
    for (Node& node : nodes_) { node.kept = (1U << node.link.rows) - 1U; }
    set_bodies(Content::jacobian, y);
    evaluate_links(Content::jacobian, t);
    measure_units();
}

template <int B>
bool BlockEquations<B>::rows_are_sound(double t, const double* y) {
    look_at_all_rows(t, y);
    std::vector<RowOfNode> doubtful;
    keep_rows_beyond(kRepeats, doubtful);
    std::fill(j_.begin(), j_.end(), 0.0);
    return smallest_pivot() > kSurelyIndependent;
}

template <int B>
bool BlockEquations<B>::choose_rows(double t, const double* y) {
    kept_before_.clear();
    masses_apart_before_ = masses_apart_;
    for (const Node& node : nodes_) { kept_before_.push_back(node.kept); }
    look_at_all_rows(t, y);
    keep_independent_rows();
    bool changed = false;
    std::fill(j_.begin(), j_.end(), 0.0);
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        changed = changed || nodes_[n].kept != kept_before_[n];
    }
    compare_masses(t);
    return changed;
}

template <int B>
void BlockEquations<B>::take_back_rows() {
    for (std::size_t n = 0; n < nodes_.size(); ++n) { nodes_[n].kept = kept_before_[n]; }
    masses_apart_ = masses_apart_before_;
    std::fill(j_.begin(), j_.end(), 0.0);
}

template <int B>
std::pair<double, double> BlockEquations<B>::violation(double t, const double* y) {
    set_bodies(Content::motion, y);
    double position = 0.0;
    double velocity = 0.0;
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        const Node& node = nodes_[n];
        const Kinematics6& i = bodies_[at(node.link.body_i)];
        const Kinematics6& j = bodies_[at(node.link.body_j)];
        for (const LinkEquation& equation : node.link.equations) {
            visit_rows<Content::motion>(
                equation.primitive, i, j, t, [&](const auto& jet, double f_dot, double) {
                    std::size_t row = n * B + at(equation.first_row);
                    for (int k = 0; k < jet.kDim; ++k) {
                        if (has(equation.left_out, k)) { continue; }
                        const double phi = up_to_turns(equation.primitive, jet.value(k));
                        position = std::max(position, std::abs(phi) * inverse_unit_[row]);
                        velocity = std::max(velocity, std::abs(jet.rate(k) - f_dot) * inverse_unit_[row]);
                        ++row;
                    }
                });
        }
    }
    return {position, velocity};
}

template double BlockEquations<3>::largest(const std::vector<double>&, bool) const;
template double BlockEquations<5>::largest(const std::vector<double>&, bool) const;
template double BlockEquations<6>::largest(const std::vector<double>&, bool) const;
template double BlockEquations<3>::project(double, double*);
template double BlockEquations<5>::project(double, double*);
template double BlockEquations<6>::project(double, double*);
template void BlockEquations<3>::meet(const std::vector<double>&, double);
template void BlockEquations<5>::meet(const std::vector<double>&, double);
template void BlockEquations<6>::meet(const std::vector<double>&, double);
template double BlockEquations<3>::size_of_six() const;
template double BlockEquations<5>::size_of_six() const;
template double BlockEquations<6>::size_of_six() const;
template void BlockEquations<3>::take_out_rows();
template void BlockEquations<5>::take_out_rows();
template void BlockEquations<6>::take_out_rows();
template bool BlockEquations<3>::rows_are_sound(double, const double*);
template bool BlockEquations<5>::rows_are_sound(double, const double*);
template bool BlockEquations<6>::rows_are_sound(double, const double*);
template bool BlockEquations<3>::choose_rows(double, const double*);
template bool BlockEquations<5>::choose_rows(double, const double*);
template bool BlockEquations<6>::choose_rows(double, const double*);
template void BlockEquations<3>::take_back_rows();
template void BlockEquations<5>::take_back_rows();
template void BlockEquations<6>::take_back_rows();
template std::pair<double, double> BlockEquations<3>::violation(double, const double*);
template std::pair<double, double> BlockEquations<5>::violation(double, const double*);
template std::pair<double, double> BlockEquations<6>::violation(double, const double*);

}  // namespace jw
