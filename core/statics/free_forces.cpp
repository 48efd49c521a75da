#include "core/statics/free_forces.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

#include "core/kinematics/manifold.hpp"
#include "core/motion/forces.hpp"
#include "core/poses/branches.hpp"
#include "core/poses/rank.hpp"

namespace jw {

namespace {

// movement of a body in a difference: for four poses, h⁴ and the rounding of loads divided by h are both
// about 1e-12 of them
constexpr double kStep = 1e-3;
// share of all inertia that an artificial coordinate gets if it moves alone: it needs some inertia
constexpr double kInertiaOfTheta = 1e-9;
constexpr double kAlone = 1e-9;
// least length of a spring that bounds the step of a difference, in extents
constexpr double kShortestSpring = 1e-6;
constexpr double kLeastInertia = 1e-15;
// share of all loads: rounding on a body without any load, since freedoms are computed together
constexpr double kNothing = 1e-14;

/// A vector of numbers between -1 and 1, the same on every machine.
VectorX drawn(Eigen::Index size, std::mt19937& random) {
    VectorX out(size);
    for (double& x : out) { x = static_cast<double>(random()) / 2147483648.0 - 1.0; }
    return out;
}

}  // namespace

FreeForces::FreeForces(const Centroidal& scene, const System& system, double t)
    : system_(&system),
      loads_(without_friction(scene.loads)),
      t_(t),
      length_(extent(system.mechanism())),
      assembler_(system),
      beside_(system),
      scaling_(scaling_of<OmegaLocal>(system)),
      least_squares_(scaling_) {}

/// M times columns, without θ, which has no mass.
VectorX FreeForces::mass_times(const VectorX& columns) const {
    VectorX out = VectorX::Zero(columns.size());
    for (const int body : system_->moving_bodies()) {
        const Eigen::Index first = system_->body_column(body, 3);
        const MassProperties& own = *loads_.masses[at(body)];
        out.segment<3>(first) = own.mass * columns.segment<3>(first);
        out.segment<3>(first + 3) = own.J_local * columns.segment<3>(first + 3);
    }
    return out;
}

VectorX FreeForces::force_at(const State& state, const Motion* velocity) const {
    const auto bodies = velocity == nullptr ? kinematics_of(state) : kinematics_of(state, *velocity);
    std::vector<BodyForce> forces(bodies.size());
    add_forces(loads_, bodies, t_, forces);
    VectorX out = VectorX::Zero(layout().columns());
    for (const int body : system_->moving_bodies()) {
        out.segment<6>(system_->body_column(body, 3)) << forces[at(body)].f, forces[at(body)].n_local;
    }
    return out;
}

/// Adds up the sizes of each load and of the reactions: those that cancel each other leave rounding of their
/// sizes.
void FreeForces::measure_loads() {
    const Loads all = loads_;
    sizes_.assign(all.masses.size(), 0.0);
    const auto add = [&](int body, const Vec3& f, const Vec3& n) {
        sizes_[at(body)] += length_ * f.norm() + n.norm();
    };
    const auto measure = [&](const VectorX& force) {
        for (const int body : system_->moving_bodies()) {
            const Eigen::Index first = system_->body_column(body, 3);
            add(body, force.segment<3>(first), force.segment<3>(first + 3));
        }
    };
    const auto measure_each = [&](auto list) {
        for (const auto& load : all.*list) {
            (loads_.*list) = {load};
            measure(force_at(state_));
        }
        (loads_.*list).clear();
    };
    loads_ = Loads{};
    loads_.masses = all.masses;
    loads_.gravity = all.gravity;
    measure(force_at(state_));
    loads_.gravity.setZero();
    measure_each(&Loads::forces);
    measure_each(&Loads::torques);
    loads_ = all;
    // of a spring, its length and its free length are subtracted from each other
    const auto bodies = kinematics_of(state_);
    const auto add_to_both = [&](const auto& spring, double size) {
        sizes_[at(spring.body_i)] += size;
        sizes_[at(spring.body_j)] += size;
    };
    for (const Spring& spring : all.springs) { add_to_both(spring, length_ * size_of(spring, bodies, t_)); }
    for (const RotationalSpring& spring : all.rotational_springs) {
        add_to_both(spring, size_of(spring, t_));
    }
    const auto size_of_law = [&](const auto& load) {
        return load.law ? load.direction.norm() * size_of(*load.law, bodies, t_) : 0.0;
    };
    for (const AppliedForce& force : all.forces) { sizes_[at(force.body)] += length_ * size_of_law(force); }
    for (const AppliedTorque& torque : all.torques) {
        sizes_[at(torque.body)] += size_of_law(torque);
        if (torque.against >= 0) { sizes_[at(torque.against)] += size_of_law(torque); }
    }
    for (const Bushing& bushing : all.bushings) {
        add_to_both(bushing, length_ * size_of(bushing, bodies, length_));
    }
    const std::vector<SparseRow>& rows = assembler_.sparse_jacobian().rows;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        for (std::size_t side = 0; side < 2; ++side) {
            if (rows[k].first_column[side] < 0) { continue; }
            const double* block = rows[k].block[side].data();
            const double lambda = lambda_(static_cast<Eigen::Index>(k));
            add(system_->moving_bodies()[at(rows[k].first_column[side] / 6)], lambda * vec3(block),
                lambda * vec3(block + 3));
        }
    }
}

/// True if an artificial coordinate moves while no body does, as where a wheel has no line.
bool FreeForces::moves_theta_alone() {
    const auto thetas = static_cast<Eigen::Index>(system_->active_thetas().size());
    const Eigen::Index bodies = layout().columns() - thetas;
    for (Eigen::Index k = 0; k < thetas; ++k) {
        VectorX column = free_part(VectorX::Unit(bodies + thetas, bodies + k));
        const double own = std::abs(column(bodies + k));
        column.tail(thetas).setZero();
        if (movement(column) < kAlone * own) { return true; }
    }
    return false;
}

/// Finds freedoms: the free parts of random columns, made orthonormal in M by a factorisation of their Gram
/// matrix; twice, since random columns are almost parallel where there are many.
void FreeForces::find_freedoms() {
    std::mt19937 random(1);
    const bool weighs_theta = moves_theta_alone();
    const Eigen::Index columns = layout().columns();
    free_.resize(columns, columns - rank_);
    for (Eigen::Index k = 0; k < free_.cols(); ++k) {
        const VectorX column = free_part(drawn(columns, random));
        free_.col(k) = column / movement(column);
    }
    for (int pass = 0; pass < 2 && free_.cols() > 0; ++pass) {
        MatrixX weighted(columns, free_.cols());
        for (Eigen::Index k = 0; k < free_.cols(); ++k) { weighted.col(k) = mass_times(free_.col(k)); }
        if (weighs_theta) {
            const auto thetas = static_cast<Eigen::Index>(system_->active_thetas().size());
            weighted.bottomRows(thetas) = kInertiaOfTheta * weighted.norm() * free_.bottomRows(thetas);
        }
        const Eigen::LDLT<MatrixX> gram(MatrixX(free_.transpose() * weighted));
        MatrixX rows = gram.transpositionsP() * free_.transpose();
        MatrixX(gram.matrixL()).triangularView<Eigen::UnitLower>().solveInPlace(rows);
        // masses may differ so much that rounding hides the light ones
        const double least = kLeastInertia * gram.vectorD().maxCoeff();
        free_ = rows.transpose() * gram.vectorD().cwiseMax(least).cwiseSqrt().cwiseInverse().asDiagonal();
    }
}

void FreeForces::set(const State& state) {
    state_ = state;
    assembler_.assemble_phi_and_jacobian(state_, t_);
    least_squares_.compute(assembler_.sparse_jacobian());
    rank_ = rank_of_all(least_squares_, scaling_.residual_of(assembler_.phi()));
    unbalanced_ = force_at(state_);
    lambda_ = VectorX::Zero(assembler_.phi().size());
    if (rank_ == 0) { return; }
    least_squares_.solve_transposed(-unbalanced_, rank_, lambda_);
    unbalanced_ += assembler_.sparse_jacobian().transposed_times(lambda_);
}

void FreeForces::find_forces() {
    find_freedoms();
    push_ = free_.transpose() * unbalanced_;
    measure_loads();
}

void FreeForces::count_turns() { jw::count_turns(loads_, kinematics_of(state_)); }

double FreeForces::residual() const {
    const VectorX left = mass_times(free_ * push_);
    // a law without a value
    if (!left.allFinite()) { return std::numeric_limits<double>::infinity(); }
    const double all = std::accumulate(sizes_.begin(), sizes_.end(), 0.0);
    double largest = 0.0;
    for (const int body : system_->moving_bodies()) {
        const Eigen::Index first = system_->body_column(body, 3);
        const double size = length_ * left.segment<3>(first).norm() + left.segment<3>(first + 3).norm();
        const bool is_rounding = std::max(size, sizes_[at(body)]) <= kNothing * all;
        if (size > 0.0 && !is_rounding) { largest = std::max(largest, size / sizes_[at(body)]); }
    }
    return largest;
}

void FreeForces::turn(const MatrixX& V) {
    free_ = free_ * V;
    push_ = V.transpose() * push_;
}

double FreeForces::movement(const VectorX& columns) const { return largest_part(*system_, columns, length_); }

double FreeForces::movement_of(int body, const VectorX& columns) const {
    const Eigen::Index first = system_->body_column(body, 3);
    return columns.segment<3>(first).norm() / length_ + columns.segment<3>(first + 3).norm();
}

double FreeForces::work_of_sizes(const VectorX& columns) const {
    double sum = 0.0;
    for (const int body : system_->moving_bodies()) { sum += sizes_[at(body)] * movement_of(body, columns); }
    return sum;
}

double FreeForces::stiffness_of_sizes(const VectorX& columns) const {
    double sum = 0.0;
    for (const int body : system_->moving_bodies()) {
        const double movement = movement_of(body, columns);
        sum += sizes_[at(body)] * movement * movement;
    }
    return sum;
}

/// Factor of columns in a difference: no body moves by more than kStep, and no spring's end by more than that
/// part of its length, on which the direction of its force depends.
double FreeForces::step_along(const VectorX& columns) const {
    double largest = movement(columns);
    const auto bodies = kinematics_of(state_, layout().motion_of(state_, columns));
    for (const Spring& spring : loads_.springs) {
        // the force of other springs is linear in their ends
        if (spring.s_i_local || spring.free_length == 0.0) { continue; }
        const SpringSpan span = span_of(spring, bodies);
        largest = std::max(largest, span.d_dot.norm() / std::max(span.d.norm(), kShortestSpring * length_));
    }
    return kStep / largest;
}

template <class F>
MatrixX FreeForces::with_linear_laws(F&& f) {
    const Loads laws = loads_;
    has_smooth_laws_ = linearise_laws(loads_, kinematics_of(state_), t_);
    MatrixX out = f();
    loads_ = laws;
    return out;
}

bool FreeForces::has_laws_of_rates() const {
    const auto has_rate = [](const auto& spring) { return spring.law && spring.law->uses(1); };
    bool any = std::ranges::any_of(loads_.springs, has_rate) ||
               std::ranges::any_of(loads_.rotational_springs, has_rate);
    for_each_law(loads_, [&](const LoadLaw& law) {
        for (std::size_t k = 0; k < law.quantities.size(); ++k) {
            any = any || law.formula.uses(LoadLaw::index_of(k, 1));
        }
    });
    return any;
}

MatrixX FreeForces::stiffness() {
    return with_linear_laws([&] { return stiffness_by_differences(); });
}

MatrixX FreeForces::damping() {
    return with_linear_laws([&] { return damping_by_differences(); });
}

MatrixX FreeForces::stiffness_by_differences() {
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
        const double h = step_along(free_.col(k));
        const auto slope = [&](double step) {
            return VectorX(
                (force_beside(step * free_.col(k)) - force_beside(-step * free_.col(k))) / (2.0 * step));
        };
        slopes.col(k) = (4.0 * slope(h) - slope(2.0 * h)) / 3.0;
    }
    return -free_.transpose() * slopes;
}

MatrixX FreeForces::damping_by_differences() const {
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
