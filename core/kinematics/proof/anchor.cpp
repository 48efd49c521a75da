#include <algorithm>
#include <cmath>

#include "core/kinematics/proof/inverse.hpp"
#include "core/kinematics/proof/norm_bound.hpp"
#include "core/kinematics/proof/proved_part.hpp"

/// Anchors of a proof: inverse Jacobians and bounds of derivatives around a pose.
namespace jw {

namespace {

// Growth of the inverse beyond which rows are chosen again.
constexpr double kWeaker = 1.5;

template <class M>
double norm_of(const M& m) {
    return m.size() == 0 ? 0.0 : m.norm();
}

}  // namespace

/// Sets an anchor at a pose. @return false if the part's equations have another rank there
bool ProvedPart::set_anchor(const StepEnd& end, Anchor& anchor) {
    anchor.is_set = false;
    anchor.t = end.t;
    anchor.centre.clear();
    for (int k = 0; k < coordinates(); ++k) {
        const Coordinates& c = step_->table().all()[at(coordinate(at(k)))];
        Vec4 x = Vec4::Zero();
        if (c.theta >= 0) {
            x(0) = end.state.theta[at(c.theta)];
        } else if (c.size == 3) {
            x.head<3>() = end.state.r[at(c.body)];
        } else {
            x = end.state.p[at(c.body)];
        }
        anchor.centre.push_back(x);
    }
    anchor.targets.clear();
    for (const int e : part_.equations) { anchor.targets.push_back(end.thetas[at(e)].value); }
    anchor.reach = 1.0;
    bound_derivatives(end, anchor);
    anchor.is_set = invert(end, anchor);
    if (anchor.is_set && has_formula_) { choose_reach(end, anchor); }
    return anchor.is_set;
}

void ProvedPart::bound_derivatives(const StepEnd& end, Anchor& anchor) const {
    const double length = step_->length();
    const std::size_t n = part_.equations.size();
    anchor.derivatives.resize(n);
    anchor.rounding.resize(n);
    anchor.i.resize(n);
    anchor.j.resize(n);
    const auto region = [&](int body) {
        const BodyKinematics<ModifiedEulerParameters>& exact = end.bodies[at(body)];
        BodyKinematics<Majorants> around;
        around.r = exact.r;
        around.p = exact.p;
        around.A = exact.A;
        const bool moves = step_->table().of_body(body) >= 0;
        around.reach_r = moves ? anchor.reach * kReachOfLength * length : 0.0;
        around.reach_p = moves ? anchor.reach * kReachOfP : 0.0;
        around.size_of_p = moves ? kSizeOfP : exact.p.norm();
        return around;
    };
    for (std::size_t g = 0; g < n; ++g) {
        const std::size_t e = at(part_.equations[g]);
        const ProvedEquation& equation = step_->equations()[e];
        anchor.i[g] = region(equation.body_i);
        anchor.j[g] = region(equation.body_j);
        const BoundedTheta theta{end.thetas[e].value, kReachOfTheta, {}};
        visit_equation<Content::jacobian>(equation, anchor.i[g], anchor.j[g], theta, [&](const auto& jet) {
            anchor.derivatives[g] = jet.bounds;
        });
        const std::array<double, kBlocks> scale{length, 1.0, length, 1.0, 1.0};
        const std::array<double, kBlocks> size{
            anchor.i[g].r.norm() / length + kReachOfLength, kSizeOfP,
            anchor.j[g].r.norm() / length + kReachOfLength, kSizeOfP, std::abs(theta.value) + theta.reach};
        DerivativeBounds& bounds = anchor.derivatives[g];
        const auto* const formula = std::get_if<FormulaEquation>(&equation.primitive);
        anchor.rounding[g] =
            formula == nullptr ? 0.0 : rounding(*formula, anchor.i[g], anchor.j[g]) / equation.unit;
        for (std::size_t c = 0; c < kBlocks; ++c) {
            bounds.first[c] *= scale[c] / equation.unit;
            anchor.rounding[g] += kRoundingOfRow * bounds.first[c] * size[c];
            for (std::size_t d = 0; d < kBlocks; ++d) {
                bounds.second[c][d] *= scale[c] * scale[d] / equation.unit;
            }
        }
    }
    anchor.curvatures.clear();
    for (std::size_t g = 0; g < n; ++g) {
        const bool is_driven = step_->equations()[at(part_.equations[g])].target != nullptr;
        std::array<int, kBlocks> along = places_[g];
        if (is_driven && along[kArtificial] < 0) { along[kArtificial] = coordinates() + static_cast<int>(g); }
        for (std::size_t c = 0; c < kBlocks; ++c) {
            for (std::size_t d = 0; d < kBlocks; ++d) {
                const double bound = anchor.derivatives[g].second[c][d];
                if (bound == 0.0 || places_[g][c] < 0 || along[d] < 0) { continue; }
                anchor.curvatures.push_back({static_cast<int>(g), places_[g][c], along[d], bound});
            }
        }
    }
}

/// Inverts the rows chosen before, or the most independent ones if those have become much weaker. Separate
/// rows fix the motions that these rows leave free.
bool ProvedPart::choose_and_invert() {
    square_.resize(part_.columns, part_.columns);
    const auto invert_chosen = [&] {
        for (int k = 0; k < part_.rank; ++k) { square_.row(k) = rows_.col(chosen_[at(k)]).transpose(); }
        inverse_ = square_;
        return invert_in_place(inverse_, pivots_) ? inverse_.norm() : HUGE_VAL;
    };
    const bool is_square = part_.rank == part_.columns;
    if (!chosen_.empty()) {
        const double size = invert_chosen();
        if (size <= kWeaker * size_of_inverse_ && has_same_rank()) {
            size_of_inverse_ = std::min(size_of_inverse_, size);
            return true;
        }
    }
    qr_.setThreshold(kIndependent);
    qr_.compute(rows_);
    if (!is_square && qr_.rank() != part_.rank) { return false; }
    chosen_.assign(
        qr_.colsPermutation().indices().begin(), qr_.colsPermutation().indices().begin() + part_.rank);
    if (!is_square) {
        MatrixX q = MatrixX::Identity(part_.columns, part_.columns);
        multiply_by_q(qr_.householderQ(), q);
        square_.bottomRows(part_.free_columns()) = q.rightCols(part_.free_columns()).transpose();
    }
    size_of_inverse_ = invert_chosen();
    if (std::isfinite(size_of_inverse_)) { return true; }
    chosen_.clear();
    return false;
}

/// True if the rows that are not chosen still vanish on what the chosen rows leave free.
bool ProvedPart::has_same_rank() const {
    const auto free = inverse_.rightCols(part_.free_columns());
    const double least = kIndependent * free.norm();
    for (int row = 0; row < part_.rows && free.cols() > 0; ++row) {
        if (std::ranges::find(chosen_, row) != chosen_.end()) { continue; }
        const auto left_out = rows_.col(row);
        if ((left_out.transpose() * free).norm() > least * left_out.norm()) { return false; }
    }
    return true;
}

/// Norms of the inverse Jacobian at an end of the step, and its defect by rounding.
bool ProvedPart::invert(const StepEnd& end, Anchor& anchor) {
    // transposed: pivots are rows
    rows_.setZero(part_.columns, part_.rows);
    others_.setZero(part_.rows, input_columns_);
    equation_of_row_.clear();
    for (std::size_t g = 0; g < part_.equations.size(); ++g) {
        const EquationJacobian& jacobian = step_->jacobian_at(end, part_.equations[g]);
        const auto row = static_cast<Eigen::Index>(equation_of_row_.size());
        for_each_block(places_[g], jacobian, [&](int k, const MatrixX& block) {
            if (at(k) < part_.unknowns.size()) {
                rows_.block(first_column_[at(k)], row, block.cols(), block.rows()) += block.transpose();
            } else {
                others_.block(row, first_column_[at(k)], block.rows(), block.cols()) += block;
            }
        });
        equation_of_row_.insert(
            equation_of_row_.end(), at(step_->equations()[at(part_.equations[g])].rows), static_cast<int>(g));
    }
    if (!choose_and_invert()) { return false; }
    const MatrixX& M = inverse_;
    // most entries of J are 0
    defect_.setIdentity(part_.columns, part_.columns);
    for (Eigen::Index c = 0; c < square_.cols(); ++c) {
        for (Eigen::Index r = 0; r < square_.rows(); ++r) {
            if (square_(r, c) != 0.0) { defect_.col(c) -= square_(r, c) * M.col(r); }
        }
    }
    input_rows_.setZero(part_.columns, input_columns_);
    for (int k = 0; k < part_.rank; ++k) { input_rows_.row(k) = others_.row(chosen_[at(k)]); }
    passed_on_.noalias() = M * input_rows_;
    measure(anchor);
    return true;
}

/// Computes the norms of the inverse.
void ProvedPart::measure(Anchor& anchor) const {
    const auto unknowns = static_cast<Eigen::Index>(part_.unknowns.size());
    anchor.inverse.setZero(unknowns, static_cast<Eigen::Index>(part_.equations.size()));
    anchor.defect.resize(unknowns, unknowns);
    anchor.passed_on.resize(unknowns, static_cast<Eigen::Index>(part_.inputs.size()));
    const auto size = [&](Eigen::Index k) { return step_->table().all()[at(coordinate(at(k)))].size; };
    for (Eigen::Index u = 0; u < unknowns; ++u) {
        const auto own = inverse_.middleRows(first_column_[at(u)], size(u));
        for (int k = 0; k < part_.rank; ++k) {
            anchor.inverse(u, equation_of_row_[at(chosen_[at(k)])]) += own.col(k).squaredNorm();
        }
        for (Eigen::Index c = 0; c < unknowns; ++c) {
            anchor.defect(u, c) =
                norm_of(defect_.block(first_column_[at(u)], first_column_[at(c)], size(u), size(c)));
        }
        for (Eigen::Index c = 0; c < anchor.passed_on.cols(); ++c) {
            const Eigen::Index k = unknowns + c;
            anchor.passed_on(u, c) =
                norm_bound(passed_on_.block(first_column_[at(u)], first_column_[at(k)], size(u), size(k)));
        }
    }
    anchor.inverse = anchor.inverse.cwiseSqrt();
    // rounding of J and of the products with M
    for (std::size_t g = 0; g < part_.equations.size(); ++g) {
        for (std::size_t b = 0; b < kBlocks; ++b) {
            const int k = places_[g][b];
            if (k < 0) { continue; }
            const double rounding =
                (part_.columns * 0x1p-53 + kRoundingOfRow) * anchor.derivatives[g].first[b];
            const bool is_own = k < unknowns;
            auto to = is_own ? anchor.defect.col(k) : anchor.passed_on.col(k - unknowns);
            to += rounding * anchor.inverse.col(static_cast<Eigen::Index>(g));
        }
    }
}

}  // namespace jw
