#include <algorithm>
#include <limits>

#include "core/equations/constraint_rounding.hpp"
#include "core/motion/dense/dense_equations.hpp"

/// Projection onto the constraints and choice of rows of the dense equations.
namespace jw {

/// Largest |Φ| or |Φ̇|, each divided by the change of its equation when bodies move by one extent of the
/// mechanism.
template <class C>
double DenseEquations<C>::largest(const VectorX& values) const {
    return values.size() > 0 ? values.cwiseProduct(inverse_size_).cwiseAbs().maxCoeff() : 0.0;
}

/// Largest value over the kept rows only.
template <class C>
double DenseEquations<C>::largest_of_kept_rows(const VectorX& values) const {
    double worst = 0.0;
    for (const int row : saddle_point_.kept()) {
        worst = std::max(worst, std::abs(values(row)) * inverse_size_(row));
    }
    return worst;
}

/// Computes the sizes of the rows; for pᵀp = 1, the size is the gradient itself.
template <class C>
void DenseEquations<C>::measure_rows() {
    const double length = extent(scene_->mechanism);
    VectorX moved = VectorX::Zero(velocity_.size());
    for (const int b : system_.moving_bodies()) {
        const int column = system_.body_column(b, C::kAngular);
        moved.segment<3>(column).setConstant(length);
        // a turn by 1 changes p by 1/2
        moved.segment<C::kAngular>(column + 3).setConstant(C::kNormalised ? 0.5 : 1.0);
    }
    const VectorX size = (jacobian() * moved.asDiagonal()).rowwise().norm();
    inverse_size_ = (size.array() > 0.0).select(size.cwiseInverse(), 1.0);
}

template <class C>
bool DenseEquations<C>::choose_rows(double t, const double* y) {
    system_before_ = system_;
    kept_before_ = saddle_point_.kept();
    read(y);
    const bool other_equations = system_.choose_rows(state_);
    assembler_.assemble_phi_and_jacobian(state_, t);
    measure_rows();
    const double threshold = rank_threshold(largest(assembler_.phi()));
    return saddle_point_.choose_rows(jacobian(), threshold) || other_equations;
}

template <class C>
bool DenseEquations<C>::follow_rule(double t, const double* y) {
    read(y);
    System by_rule = system_;
    if (!by_rule.choose_rows(state_)) { return false; }
    choose_rows(t, y);
    return true;
}

/// Largest rotation in a step. With the rule, an axis lies at least asin(0.8 / √3) = 0.48 rad from the plane
/// in which its pair loses rank. Turns of screws are those nearest to the last ones.
template <class C>
double DenseEquations<C>::most_turn() const {
    constexpr double margin = 0.4;
    const auto by_rule = [&](const Constraint& c) {
        const Joint& joint = scene_->mechanism.joints[at(c.joint)];
        return c.dropped >= 0 && joint.parallel_form == ParallelForm::rule;
    };
    if (std::ranges::any_of(system_.constraints(), by_rule)) { return margin; }
    return state_.theta.empty() ? MotionEquations::most_turn() : kCountedTurn;
}

template <class C>
void DenseEquations<C>::take_back_rows() {
    system_ = system_before_;
    saddle_point_.keep(kept_before_);
}

/// Newton in the metric of M: M Δq - Φqᵀ μ = 0, Φq Δq = -Φ.
template <class C>
double DenseEquations<C>::correct_positions(double t) {
    double before = 0.0;
    const VectorX none = VectorX::Zero(velocity_.size());
    double last = std::numeric_limits<double>::infinity();
    for (int round = 0; round < kMostRounds; ++round) {
        assembler_.assemble_phi_and_jacobian(state_, t);
        const double worst = largest_of_kept_rows(assembler_.phi());
        if (round == 0) { before = worst; }
        set_mass();
        saddle_point_.factor(mass_, jacobian());
        if (is_at_rounding(worst, last)) { break; }
        last = worst;
        VectorX delta;
        saddle_point_.solve(none, -assembler_.phi(), delta, lambda_);
        assembler_.layout().advance(state_, delta);
        for (const int b : system_.moving_bodies()) {
            state_.p[at(b)].normalize();
            bodies_[at(b)].p = state_.p[at(b)];
            bodies_[at(b)].A = homogeneous_rotation_matrix(state_.p[at(b)]);
        }
    }
    return before;
}

template <class C>
double DenseEquations<C>::project(double t, double* y) {
    read(y);
    for (const int b : system_.moving_bodies()) { state_.p[at(b)].normalize(); }
    const double before = correct_positions(t);
    // velocities nearest to the previous ones: M (q̇ - q̇*) - Φqᵀ μ = 0, Φq q̇ = ν
    assembler_.assemble_nu(t);
    velocity_ = assembler_.layout().columns_of(state_, motion_);
    VectorX corrected;
    saddle_point_.solve(mass_ * velocity_, assembler_.nu(), corrected, lambda_);
    motion_ = assembler_.layout().motion_of(state_, corrected);
    pack(state_, motion_, y);
    return before;
}

template <class C>
std::pair<double, double> DenseEquations<C>::violation(double t, const double* y) {
    read(y);
    assembler_.assemble_phi_and_jacobian(state_, t);
    assembler_.assemble_nu(t);
    const VectorX phi_dot = jacobian() * velocity_ - assembler_.nu();
    return {largest(assembler_.phi()), largest(phi_dot)};
}

// members used elsewhere; dense_equations.cpp instantiates the class
#define JW_INSTANTIATE(C)                                                          \
    template double DenseEquations<C>::largest_of_kept_rows(const VectorX&) const; \
    template bool DenseEquations<C>::choose_rows(double, const double*);           \
    template bool DenseEquations<C>::follow_rule(double, const double*);           \
    template double DenseEquations<C>::most_turn() const;                          \
    template void DenseEquations<C>::take_back_rows();                             \
    template double DenseEquations<C>::project(double, double*);                   \
    template std::pair<double, double> DenseEquations<C>::violation(double, const double*);
JW_INSTANTIATE(TrueEulerParameters)
JW_INSTANTIATE(ModifiedEulerParameters)
JW_INSTANTIATE(OmegaLocal)
JW_INSTANTIATE(OmegaGlobal)
#undef JW_INSTANTIATE

}  // namespace jw
