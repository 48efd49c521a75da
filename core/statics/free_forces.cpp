#include "core/statics/free_forces.hpp"

#include <algorithm>
#include <random>

#include "core/jets/body_kinematics.hpp"
#include "core/motion/forces.hpp"
#include "core/poses/branches.hpp"
#include "core/poses/rank.hpp"

namespace jw {

namespace {

// movement of a body in a difference: for four poses, h⁴ and the rounding of loads divided by h are both
// about 1e-12 of them
constexpr double kStep = 1e-3;
// of the largest inertia: only where a wheel has no line, θ moves alone; it must not be without inertia
constexpr double kInertiaOfTheta = 1e-9;
constexpr double kLeastInertia = 1e-15;

/// A vector of numbers between -1 and 1, the same on every machine.
VectorX drawn(Eigen::Index size, std::mt19937& random) {
    VectorX out(size);
    for (double& x : out) { x = static_cast<double>(random()) / 2147483648.0 - 1.0; }
    return out;
}

}  // namespace

FreeForces::FreeForces(const Centroidal& scene, const System& system, double t)
    : system_(&system),
      loads_(scene.loads),
      t_(t),
      length_(extent(system.mechanism())),
      assembler_(system),
      beside_(system),
      least_squares_(scaling_of<OmegaLocal>(system)),
      scaling_(scaling_of<OmegaLocal>(system)) {}

VectorX FreeForces::mass_times(const VectorX& columns) const {
    VectorX out = columns;
    double largest = 0.0;
    for (const int body : system_->moving_bodies()) {
        const Eigen::Index first = system_->body_column(body, 3);
        const MassProperties& own = *loads_.masses[at(body)];
        out.segment<3>(first) *= own.mass;
        out.segment<3>(first + 3) = own.J_local * columns.segment<3>(first + 3);
        largest = std::max(largest, own.mass * length_ * length_ + own.J_local.trace());
    }
    out.tail(static_cast<Eigen::Index>(system_->active_thetas().size())) *= kInertiaOfTheta * largest;
    return out;
}

VectorX FreeForces::force_at(const State& state, const Motion* velocity) const {
    std::vector<BodyKinematics<OmegaLocal>> bodies = kinematics_of(state);
    if (velocity != nullptr) {
        for (std::size_t b = 0; b < bodies.size(); ++b) {
            bodies[b] = kinematics_at<OmegaLocal>(
                state.r[b], state.p[b], velocity->r_dot[b], velocity->omega_local[b]);
        }
    }
    std::vector<BodyForce> forces(bodies.size());
    add_forces(loads_, bodies, t_, forces);
    VectorX out = VectorX::Zero(layout().columns());
    for (const int body : system_->moving_bodies()) {
        out.segment<6>(system_->body_column(body, 3)) << forces[at(body)].f, forces[at(body)].n_local;
    }
    return out;
}

/// Adds up what each load does by itself: loads that cancel each other leave rounding of their sizes.
void FreeForces::measure_loads() {
    const Loads all = loads_;
    size_ = 0.0;
    const auto measure = [&] {
        const VectorX force = force_at(state_);
        for (const int body : system_->moving_bodies()) {
            const Eigen::Index first = system_->body_column(body, 3);
            size_ += length_ * force.segment<3>(first).norm() + force.segment<3>(first + 3).norm();
        }
    };
    const auto measure_each = [&](auto list) {
        for (const auto& load : all.*list) {
            (loads_.*list) = {load};
            measure();
        }
        (loads_.*list).clear();
    };
    loads_ = Loads{};
    loads_.masses = all.masses;
    loads_.gravity = all.gravity;
    measure();
    loads_.gravity.setZero();
    measure_each(&Loads::forces);
    measure_each(&Loads::torques);
    measure_each(&Loads::springs);
    measure_each(&Loads::rotational_springs);
    loads_ = all;
}

/// Freedoms are the free parts of random columns, made orthonormal in M by a factorisation of their Gram
/// matrix; twice, since random columns are almost parallel where there are many.
void FreeForces::find_freedoms() {
    std::mt19937 random(1);
    const Eigen::Index columns = layout().columns();
    free_.resize(columns, columns - rank_);
    for (Eigen::Index k = 0; k < free_.cols(); ++k) {
        const VectorX column = free_part(drawn(columns, random));
        free_.col(k) = column / movement(column);
    }
    for (int pass = 0; pass < 2 && free_.cols() > 0; ++pass) {
        MatrixX weighted(columns, free_.cols());
        for (Eigen::Index k = 0; k < free_.cols(); ++k) { weighted.col(k) = mass_times(free_.col(k)); }
        const Eigen::LDLT<MatrixX> gram(MatrixX(free_.transpose() * weighted));
        MatrixX rows = gram.transpositionsP() * free_.transpose();
        MatrixX(gram.matrixL()).triangularView<Eigen::UnitLower>().solveInPlace(rows);
        // masses so far apart that rounding hides the light ones
        const double least = kLeastInertia * gram.vectorD().maxCoeff();
        free_ = rows.transpose() * gram.vectorD().cwiseMax(least).cwiseSqrt().cwiseInverse().asDiagonal();
    }
}

void FreeForces::set(const State& state) {
    state_ = state;
    assembler_.assemble_phi_and_jacobian(state_, t_);
    least_squares_.compute(assembler_.sparse_jacobian());
    const VectorX& phi = assembler_.phi();
    const double residual = phi.size() == 0 ? 0.0 : phi.cwiseQuotient(scaling_.row).cwiseAbs().maxCoeff();
    rank_ = least_squares_.rank(std::max(kRankThreshold, kErrorFactor * residual));
}

void FreeForces::find_forces() {
    find_freedoms();
    const VectorX force = force_at(state_);
    lambda_ = VectorX::Zero(assembler_.phi().size());
    if (rank_ > 0) { least_squares_.solve_transposed(-force, rank_, lambda_); }
    push_ = free_.transpose() * force;
    measure_loads();
}

void FreeForces::count_turns() { jw::count_turns(loads_, kinematics_of(state_)); }

double FreeForces::residual() const {
    double largest = 0.0;
    for (Eigen::Index k = 0; k < push_.size() && size_ > 0.0; ++k) {
        largest = std::max(largest, std::abs(push_(k)) / (size_ * movement(free_.col(k))));
    }
    return largest;
}

double FreeForces::movement(const VectorX& columns) const { return largest_part(*system_, columns, length_); }

MatrixX FreeForces::stiffness(int points) {
    MatrixX slopes(free_.rows(), free_.cols());
    State there;
    // Q + Φqᵀ λ at a movement from here
    const auto force_beside = [&](const VectorX& columns) {
        there = state_;
        layout().advance(there, columns);
        beside_.assemble_phi_and_jacobian(there, t_);
        return VectorX(force_at(there) + beside_.sparse_jacobian().transposed_times(lambda_));
    };
    for (Eigen::Index k = 0; k < free_.cols(); ++k) {
        const double h = kStep / movement(free_.col(k));
        const auto slope = [&](double step) {
            return VectorX(
                (force_beside(step * free_.col(k)) - force_beside(-step * free_.col(k))) / (2.0 * step));
        };
        slopes.col(k) = points == 2 ? slope(h) : VectorX((4.0 * slope(h) - slope(2.0 * h)) / 3.0);
    }
    return -free_.transpose() * slopes;
}

double FreeForces::stiffness_size() const {
    double largest = 0.0;
    for (Eigen::Index k = 0; k < free_.cols(); ++k) { largest = std::max(largest, movement(free_.col(k))); }
    return size_ * largest * largest;
}

MatrixX FreeForces::damping() const {
    MatrixX C(free_.cols(), free_.cols());
    for (Eigen::Index k = 0; k < free_.cols(); ++k) {
        const Motion forwards = layout().motion_of(state_, free_.col(k));
        const Motion backwards = layout().motion_of(state_, -free_.col(k));
        C.col(k) = -0.5 * free_.transpose() * (force_at(state_, &forwards) - force_at(state_, &backwards));
    }
    return C;
}

VectorX FreeForces::free_part(VectorX columns) {
    least_squares_.keep_free_part(rank_, columns);
    return columns;
}

}  // namespace jw
