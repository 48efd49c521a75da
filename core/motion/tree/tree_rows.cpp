#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/equations/constraint_rounding.hpp"
#include "core/motion/tree/tree_equations.hpp"
#include "core/numerics/flatten.hpp"

/// Rows of the loops of a tree: those of the cut joints, the choice of independent rows, and projection onto
/// them.
namespace jw {

namespace {

bool has(unsigned rows, int row) { return ((rows >> row) & 1U) != 0; }

}  // namespace

/// Converts a row's block of a body, in ω', to a wrench at the root of its node.
Six TreeEquations::at_root(int node, const Mat3& A, const Eigen::Matrix<double, 1, 6>& block) const {
    return tree_.at_root(node, block.head<3>().transpose(), A * block.tail<3>().transpose());
}

void TreeEquations::evaluate_rows_of(const Group& group, double t) {
    const LinkEquation& equation = *group.equation;
    const BodyKinematics<OmegaLocal>& i = bodies_[at(group.link->body_i)];
    const BodyKinematics<OmegaLocal>& j = bodies_[at(group.link->body_j)];
    Row* row = &rows_[at(group.first_row)];
    visit_rows<Content::jacobian>(equation.primitive, i, j, t, [&](const auto& jet, double, double) {
        using Jet = std::decay_t<decltype(jet)>;
        for (int k = 0; k < Jet::kDim; ++k) {
            if (has(equation.left_out, k)) { continue; }
            row->phi = jet.value(k);
            if constexpr ((Jet::kSides & kBodyI) != 0) {
                row->on_i = at_root(row->node_i, i.A, jet.block_i.row(k));
            }
            if constexpr ((Jet::kSides & kBodyJ) != 0) {
                row->on_j = at_root(row->node_j, j.A, jet.block_j.row(k));
            }
            ++row;
        }
    });
    row = &rows_[at(group.first_row)];
    visit_rows<Content::motion>(
        equation.primitive, i, j, t, [&](const auto& jet, double f_dot, double f_ddot) {
            for (int k = 0; k < jet.kDim; ++k) {
                if (has(equation.left_out, k)) { continue; }
                row->rate = jet.rate(k) - f_dot;
                row->gamma = f_ddot - jet.bias(k);
                ++row;
            }
        });
}

JW_FLATTEN void TreeEquations::evaluate_rows(double t, const std::vector<Group>& groups) {
    for (const Group& group : groups) { evaluate_rows_of(group, t); }
}

void TreeEquations::respond(const std::vector<int>& rows) {
    for (const int k : rows) {
        const Row& row = rows_[at(k)];
        tree_.respond(
            row.node_i, row.node_j, row.on_i, row.on_j, e_of_rows_.data() + row.first_e,
            e_by_D_.data() + row.first_e);
    }
}

void TreeEquations::factor_rows() {
    respond(kept_);
    std::ranges::fill(matrix_.numbers(), 0.0);
    for (const Product& product : products_) {
        matrix_.numbers()[product.target] += e_of_rows_[product.e] * e_by_D_[product.e_by_D];
    }
    matrix_.factor();
    smallest_pivot_ = 1.0;
    for (int k = 0; k < matrix_.rows(); ++k) {
        const double share = matrix_(k, k) / rows_[at(kept_[at(k)])].size;
        // a pivot that rounding made negative counts as 0
        smallest_pivot_ = std::min(smallest_pivot_, share > 0.0 ? share : 0.0);
    }
}

void TreeEquations::add_answer_of_rows() {
    matrix_.solve(lambda_.data());
    for (std::size_t k = 0; k < kept_.size(); ++k) {
        const Row& row = rows_[at(kept_[k])];
        const double* e = e_of_rows_.data() + row.first_e;
        for (const int u : row.path) { tree_.e()[at(u)] += *e++ * lambda_[k]; }
    }
}

void TreeEquations::take_out(double Row::*number) {
    for (std::size_t k = 0; k < kept_.size(); ++k) { lambda_[k] = -(rows_[at(kept_[k])].*number); }
    std::ranges::fill(tree_.e(), 0.0);
    add_answer_of_rows();
    tree_.unfold();
}

double TreeEquations::largest_of_kept_rows(double Row::*number) const {
    double worst = 0.0;
    for (const int k : kept_) {
        worst = std::max(worst, std::abs(rows_[at(k)].*number) * rows_[at(k)].inverse_unit);
    }
    return worst;
}

double TreeEquations::project(double t, double* y) {
    joints().for_each_part([](int, int) {}, [](int, int) {}, [&](int p, int) { vec4(y + p).normalize(); });
    if (rows_.empty()) { return 0.0; }
    double before = 0.0;
    double last = std::numeric_limits<double>::infinity();
    for (int round = 0; round < kMostRounds; ++round) {
        place(y);
        set_bodies(y);
        evaluate_rows(t, kept_groups_);
        tree_.set_inertias(Metric::mass);
        tree_.fold();
        factor_rows();
        const double worst = largest_of_kept_rows(&Row::phi);
        if (round == 0) { before = worst; }
        if (is_at_rounding(worst, last)) { break; }
        last = worst;
        take_out(&Row::phi);
        displace(y);
    }
    // twice: the first solution carries the rounding of the rates that it cancels
    take_out(&Row::rate);
    add_velocities(y);
    tree_.move(y);
    set_bodies(y);
    evaluate_rows(t, kept_groups_);
    take_out(&Row::rate);
    add_velocities(y);
    return before;
}

/// Computes the sizes of the rows for unconstrained bodies.
void TreeEquations::measure_rows() {
    for (Row& row : rows_) {
        double by_mass = 0.0;
        double by_length = 0.0;
        for (const auto& [n, on] : {std::pair{row.node_i, &row.on_i}, std::pair{row.node_j, &row.on_j}}) {
            if (n == 0) { continue; }
            const MassProperties& own = *scene_->loads.masses[at(tree_.joint_of(n).body)];
            const Vec3 way = vec3(on->linear);
            const Vec3 turn = vec3(on->angular) - vec3(tree_.node(n).own_arm).cross(way);
            const Vec3 turn_local = mat3(tree_.node(n).A).transpose() * turn;
            by_mass += way.squaredNorm() / own.mass + turn_local.dot(own.J_local.inverse() * turn_local);
            by_length += way.squaredNorm() + turn.squaredNorm() / (extent_ * extent_);
        }
        row.size = by_mass > 0.0 ? by_mass : 1.0;
        row.inverse_unit = by_length > 0.0 ? 1.0 / (extent_ * std::sqrt(by_length)) : 1.0;
    }
}

/// Gram-Schmidt over the rows of E, the row with the largest remainder first. Loops without a common joint
/// are orthogonal, so only the range of u that a row reaches is used.
std::vector<int> TreeEquations::independent_rows() const {
    struct Stretch {
        Eigen::Index first;
        Eigen::Index end;
    };
    const auto count = static_cast<Eigen::Index>(rows_.size());
    // a column per row
    MatrixX E = MatrixX::Zero(joints().velocities(), count);
    MatrixX E_by_D = E;
    std::vector<Stretch> reaches;
    for (Eigen::Index k = 0; k < count; ++k) {
        const Row& row = rows_[static_cast<std::size_t>(k)];
        Stretch reach{E.rows(), 0};
        for (std::size_t u = 0; u < row.path.size(); ++u) {
            const Eigen::Index place = row.path[u];
            E(place, k) = e_of_rows_[row.first_e + u];
            E_by_D(place, k) = e_by_D_[row.first_e + u];
            reach = {std::min(reach.first, place), std::max(reach.end, place + 1)};
        }
        reaches.push_back(reach);
    }
    const auto reach_of = [&](Eigen::Index k) -> Stretch& { return reaches[static_cast<std::size_t>(k)]; };
    const auto part = [](MatrixX& matrix, Eigen::Index k, const Stretch& s) {
        return matrix.col(k).segment(s.first, s.end - s.first);
    };
    VectorX left(count);
    const auto measure = [&](Eigen::Index k) {
        const double unit = extent_ * rows_[static_cast<std::size_t>(k)].inverse_unit;
        const Stretch& reach = reach_of(k);
        left(k) = reach.first < reach.end ? part(E, k, reach).dot(part(E_by_D, k, reach)) * unit * unit : 0.0;
    };
    for (Eigen::Index k = 0; k < count; ++k) { measure(k); }
    std::vector<int> chosen;
    while (chosen.size() < rows_.size()) {
        Eigen::Index best = 0;
        if (!(left.maxCoeff(&best) > kRepeats)) { break; }
        chosen.push_back(static_cast<int>(best));
        const Stretch reach = reach_of(best);
        const auto e = part(E, best, reach);
        const auto e_by_D = part(E_by_D, best, reach);
        const double square = e.dot(e_by_D);
        left(best) = 0.0;
        for (Eigen::Index k = 0; k < count; ++k) {
            Stretch& other = reach_of(k);
            if (left(k) == 0.0 || other.first >= reach.end || reach.first >= other.end) { continue; }
            const double share = e_by_D.dot(part(E, k, reach)) / square;
            if (share == 0.0) { continue; }
            part(E, k, reach) -= share * e;
            part(E_by_D, k, reach) -= share * e_by_D;
            other = {std::min(other.first, reach.first), std::max(other.end, reach.end)};
            measure(k);
        }
    }
    std::ranges::sort(chosen);
    return chosen;
}

/// Chooses independent rows in the metric of geometry: redundancy does not depend on masses.
bool TreeEquations::choose_rows(double t, const double* y) {
    kept_before_ = kept_;
    place(y);
    set_bodies(y);
    evaluate_rows(t, groups_);
    measure_rows();
    tree_.set_inertias(Metric::geometry, extent_);
    tree_.fold();
    std::vector<int> all(rows_.size());
    std::iota(all.begin(), all.end(), 0);
    respond(all);
    keep(independent_rows());
    return kept_ != kept_before_;
}

void TreeEquations::take_back_rows() { keep(kept_before_); }

/// Keeps these rows and lists the products of which their matrix E D⁻¹ Eᵀ consists.
void TreeEquations::keep(std::vector<int> rows) {
    if (rows == kept_) { return; }
    kept_ = std::move(rows);
    lambda_.assign(kept_.size(), 0.0);
    kept_groups_.clear();
    std::ranges::copy_if(groups_, std::back_inserter(kept_groups_), [&](const Group& group) {
        return std::ranges::any_of(kept_, [&](int row) {
            return row >= group.first_row && row < group.first_row + group.equation->rows;
        });
    });
    struct Shared {
        int a;
        int b;
        std::size_t e;
        std::size_t e_by_D;
    };
    std::vector<Shared> all;
    std::vector<int> first(kept_.size());
    for (std::size_t a = 0; a < kept_.size(); ++a) {
        first[a] = static_cast<int>(a);
        const Row& row = rows_[at(kept_[a])];
        for (std::size_t b = 0; b <= a; ++b) {
            const Row& other = rows_[at(kept_[b])];
            for (std::size_t k = 0; k < row.path.size(); ++k) {
                const auto same = std::ranges::find(other.path, row.path[k]);
                if (same == other.path.end()) { continue; }
                first[a] = std::min(first[a], static_cast<int>(b));
                const auto place = static_cast<std::size_t>(same - other.path.begin());
                all.push_back(
                    {static_cast<int>(a), static_cast<int>(b), row.first_e + k, other.first_e + place});
            }
        }
    }
    matrix_ = EnvelopeMatrix(std::move(first));
    products_.clear();
    for (const Shared& s : all) { products_.push_back({matrix_.index(s.a, s.b), s.e, s.e_by_D}); }
}

double TreeEquations::products_of_rows(double kept) const {
    const auto velocities = at(joints().velocities());
    std::vector<double> rows_on(velocities, 0.0);
    std::vector<std::size_t> first_on(velocities, rows_.size());
    // it takes some fifty products per joint to transfer a wrench along a path
    constexpr double per_joint = 50.0;
    double products = 0.0;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
        std::size_t first = k;
        for (const int u : rows_[k].path) {
            rows_on[at(u)] += 1.0;
            first_on[at(u)] = std::min(first_on[at(u)], k);
            first = std::min(first, first_on[at(u)]);
        }
        const auto width = kept * static_cast<double>(k - first);
        products += kept * (per_joint * static_cast<double>(rows_[k].path.size()) + 0.5 * width * width);
    }
    for (const double rows : rows_on) { products += 0.5 * kept * kept * rows * rows; }
    return products;
}

std::pair<double, double> TreeEquations::violation(double t, const double* y) {
    // usually called at the end of a step, which has just been evaluated
    if (!is_evaluated_at(t, y)) {
        place(y);
        set_bodies(y);
    }
    evaluate_rows(t, groups_);
    std::pair<double, double> worst{0.0, 0.0};
    for (const Row& row : rows_) {
        worst.first = std::max(worst.first, std::abs(row.phi) * row.inverse_unit);
        worst.second = std::max(worst.second, std::abs(row.rate) * row.inverse_unit);
    }
    return worst;
}

}  // namespace jw
