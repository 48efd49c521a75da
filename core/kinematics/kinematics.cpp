#include "core/kinematics/kinematics.hpp"

#include <algorithm>

#include "core/poses/rank.hpp"

namespace jw {

namespace {

// rounding of velocities is some 1e-15 times the condition; a contradiction has the size of the drivers
constexpr double kConsistent = 1e-7;

}  // namespace

template <class C>
Kinematics<C>::Kinematics(const System& system)
    : system_(&system), assembler_(system), scaling_(scaling_of<C>(system)), least_squares_(scaling_) {}

template <class C>
void Kinematics<C>::set_state(const State& state, double t) {
    state_ = state;
    t_ = t;
    assembler_.assemble_phi_and_jacobian(state_, t_);
    least_squares_.compute(assembler_.sparse_jacobian());
    // the same threshold as for singular values: the pivot of a redundant row, and its contradiction, are
    // about as large as the position error
    residual_ = scaling_.residual_of(assembler_.phi());
    position_error_ = residual_ <= kAssembledResidual ? kErrorFactor * residual_ : 0.0;
    rank_ = least_squares_.rank(std::max(kRankThreshold, position_error_));
}

template <class C>
State Kinematics<C>::corrected_state() {
    right_side_ = -assembler_.phi();
    least_squares_.solve(right_side_, rank_, solution_);
    State state = state_;
    assembler_.layout().advance(state, solution_);
    for (const int body : system_->moving_bodies()) { state.p[static_cast<std::size_t>(body)].normalize(); }
    return state;
}

template <class C>
double Kinematics<C>::last_pivot_ratio() const {
    if (rank_ < 2) { return 1.0; }
    return least_squares_.relative_pivot(rank_ - 1) / least_squares_.relative_pivot(rank_ - 2);
}

template <class C>
void Kinematics<C>::leave_out_weakest() {
    --rank_;
    position_error_ = std::max(position_error_, kErrorFactor * least_squares_.relative_pivot(rank_));
}

template <class C>
VectorX Kinematics<C>::product(const VectorX& x) const {
    if (!least_squares_.is_sparse()) { return assembler_.jacobian() * x; }
    VectorX out;
    assembler_.sparse_jacobian().multiply(x, out);
    return out;
}

template <class C>
LinearVerdict Kinematics<C>::verdict_of(const VectorX& x, const VectorX& b) {
    LinearVerdict verdict;
    verdict.rank = rank_;
    verdict.unique = rank_ == static_cast<int>(scaling_.column.size());
    if (b.size() == 0) { return verdict; }
    miss_ = (product(x) - b).cwiseQuotient(scaling_.row);
    Eigen::Index worst = 0;
    const double largest = miss_.cwiseAbs().maxCoeff(&worst);
    const double size = std::max(1.0, b.cwiseQuotient(scaling_.row).cwiseAbs().maxCoeff());
    verdict.residual = largest / size;
    verdict.worst_row = static_cast<int>(worst);
    verdict.consistent = verdict.residual <= std::max(kConsistent, position_error_);
    return verdict;
}

template <class C>
VelocityOutcome Kinematics<C>::solve_velocity(const Motion& reference) {
    assembler_.assemble_nu(t_);
    const VectorX x_reference = assembler_.layout().columns_of(state_, reference);
    if (least_squares_.is_sparse()) {
        right_side_ = assembler_.nu() - product(x_reference);
    } else {
        right_side_ = assembler_.nu() - assembler_.jacobian() * x_reference;
    }
    least_squares_.solve(right_side_, rank_, solution_);
    solution_ += x_reference;
    return {assembler_.layout().motion_of(state_, solution_), verdict_of(solution_, assembler_.nu())};
}

template <class C>
AccelerationOutcome Kinematics<C>::solve_acceleration(const Motion& velocity) {
    assembler_.assemble_gamma(state_, velocity, t_);
    least_squares_.solve(assembler_.gamma(), rank_, solution_);
    return {
        assembler_.layout().acceleration_of(state_, solution_), verdict_of(solution_, assembler_.gamma())};
}

template class Kinematics<TrueEulerParameters>;
template class Kinematics<ModifiedEulerParameters>;
template class Kinematics<OmegaLocal>;
template class Kinematics<OmegaGlobal>;

}  // namespace jw
