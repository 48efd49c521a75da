#include "core/kinematics.hpp"

#include <algorithm>

namespace jw {

namespace {

// a redundant row at a pose assembled to 1e-13 has a pivot of about 1e-13; real ones are far larger
constexpr double kThreshold = 1e-9;
// rounding of velocities is some 1e-15 times the condition; a contradiction is of the size of the drivers
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
    least_squares_.compute(assembler_.jacobian());
    rank_ = least_squares_.rank(kThreshold);
}

template <class C>
double Kinematics<C>::last_pivot_ratio() const {
    if (rank_ < 2) { return 1.0; }
    return least_squares_.relative_pivot(rank_ - 1) / least_squares_.relative_pivot(rank_ - 2);
}

template <class C>
LinearVerdict Kinematics<C>::verdict_of(const VectorX& x, const VectorX& b) const {
    LinearVerdict verdict;
    verdict.rank = rank_;
    verdict.unique = rank_ == static_cast<int>(scaling_.column.size());
    if (b.size() == 0) { return verdict; }
    const VectorX miss = (assembler_.jacobian() * x - b).cwiseQuotient(scaling_.row);
    Eigen::Index worst = 0;
    const double largest = miss.cwiseAbs().maxCoeff(&worst);
    const double size = std::max(1.0, b.cwiseQuotient(scaling_.row).cwiseAbs().maxCoeff());
    verdict.residual = largest / size;
    verdict.worst_row = static_cast<int>(worst);
    verdict.consistent = verdict.residual <= kConsistent;
    return verdict;
}

template <class C>
VelocityOutcome Kinematics<C>::solve_velocity(const Motion& reference) {
    assembler_.assemble_nu(t_);
    const VectorX x_reference = assembler_.layout().columns_of(state_, reference);
    right_side_ = assembler_.nu() - assembler_.jacobian() * x_reference;
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
