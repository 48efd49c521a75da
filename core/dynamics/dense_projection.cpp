#include <algorithm>
#include <limits>

#include "core/dynamics/dense_equations.hpp"

/// What the dense equations do besides accelerations: back onto the constraints, choice of rows.
namespace jw {

namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

}  // namespace

/// Largest of Φ or Φ̇, each by the change of its equation when bodies move by one extent of the mechanism.
template <class C>
double DenseEquations<C>::largest(const VectorX& values) const {
    return values.size() > 0 ? values.cwiseProduct(inverse_size_).cwiseAbs().maxCoeff() : 0.0;
}

/// For pᵀp = 1 that is its size itself.
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

/// The axis lies at least asin(0.8 / √3) = 0.48 rad beside the plane in which the pair loses its rank.
template <class C>
double DenseEquations<C>::most_turn() const {
    constexpr double margin = 0.4;
    const auto by_rule = [&](const Constraint& c) {
        const Joint& joint = scene_->mechanism.joints[at(c.joint)];
        return c.dropped >= 0 && joint.parallel_form == ParallelForm::rule;
    };
    return std::ranges::any_of(system_.constraints(), by_rule) ? margin : MotionEquations::most_turn();
}

template <class C>
void DenseEquations<C>::take_back_rows() {
    system_ = system_before_;
    saddle_point_.keep(kept_before_);
}

/// Newton in the metric of M: M Δq - Φqᵀ μ = 0, Φq Δq = -Φ.
template <class C>
void DenseEquations<C>::correct_positions(double t, double& before) {
    // from the error of a step three rounds reach rounding; close to it, a fall by less than half is the end
    constexpr int most_rounds = 12;
    constexpr double close = 1e-6;
    const VectorX none = VectorX::Zero(velocity_.size());
    double last = std::numeric_limits<double>::infinity();
    for (int round = 0; round < most_rounds; ++round) {
        assembler_.assemble_phi_and_jacobian(state_, t);
        const double worst = largest(assembler_.phi());
        if (round == 0) { before = worst; }
        set_mass();
        saddle_point_.factor(mass_, jacobian());
        if (worst < 1e-14 || (worst < close && worst > 0.5 * last)) { return; }
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
}

template <class C>
double DenseEquations<C>::project(double t, double* y) {
    read(y);
    for (const int b : system_.moving_bodies()) { state_.p[at(b)].normalize(); }
    double before = 0.0;
    correct_positions(t, before);
    // velocities nearest to those that were: M (q̇ - q̇*) - Φqᵀ μ = 0, Φq q̇ = ν
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

// the members above; those of dense_equations.cpp are instantiated there
template class DenseEquations<TrueEulerParameters>;
template class DenseEquations<ModifiedEulerParameters>;
template class DenseEquations<OmegaLocal>;
template class DenseEquations<OmegaGlobal>;

}  // namespace jw
