#include "core/kinematics/driven_frames.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/motion/flat_state.hpp"
#include "core/poses/branches.hpp"

namespace jw {

namespace {

/// Least RowsVerdict::smallest_pivot of rows that count as independent. Measured on Bennett's mechanism near
/// its folded position: accelerations are good to 1e-13 at this value, and lose a digit for each power of ten
/// below it.
constexpr double kLeastPivot = kSurelyIndependent;
/// Rounding of Φ divided by the size of its equations; redundant rows that contradict the others are above
/// it.
constexpr double kHolds = 1e-13;
/// Largest |Φ| of a prediction, divided by the size of its equations, whose factorisation can also be used at
/// the pose: each refinement then leaves less than 1e-5, as pivots are not below kLeastPivot.
constexpr double kNear = 1e-8;
/// Longest step for which a polynomial is continued, in multiples of the time between two of its poses:
/// errors of poses and of the polynomial grow with the ninth power of this.
constexpr double kMostContinued = 1.5;

Loads unit_masses(const Mechanism& mechanism) {
    const double length = extent(mechanism);
    Loads loads;
    loads.masses.assign(
        mechanism.bodies.size(), MassProperties{1.0, Vec3::Zero(), length * length * Mat3::Identity()});
    return loads;
}

/// Largest movement of a body between two rows of numbers, in `length` and rad.
double movement(const std::vector<double>& from, const std::vector<double>& to, double length) {
    double largest = 0.0;
    for (std::size_t k = 0; k < from.size(); k += kNumbersPerBody) {
        // |Δp| is half the turn
        largest = std::max(
            {largest, (vec3(&to[k]) - vec3(&from[k])).norm() / length,
             2.0 * (vec4(&to[k + 3]) - vec4(&from[k + 3])).norm()});
    }
    return largest;
}

}  // namespace

bool DrivenFrames::can_follow(const System& system) {
    const Mechanism& mechanism = system.mechanism();
    return !mechanism.drivers.empty() && system.active_thetas().empty() &&
           system.selection().joints.size() == mechanism.joints.size() &&
           system.selection().drivers.size() == mechanism.drivers.size();
}

DrivenFrames::DrivenFrames(const System& system)
    : system_(&system),
      scene_(centroidal(system.mechanism(), unit_masses(system.mechanism()))),
      equations_(block_equations(scene_)),
      length_(extent(system.mechanism())) {
    const auto size = static_cast<std::size_t>(equations_->size());
    for (std::vector<double>* numbers : {&y_, &y_dot_, &predicted_, &y_new_, &y_dot_new_}) {
        numbers->assign(size, 0.0);
    }
}

bool DrivenFrames::is_sound(const RowsVerdict& verdict) const {
    return verdict.smallest_pivot >= kLeastPivot && verdict.violation <= kHolds && verdict.left_out <= kHolds;
}

bool DrivenFrames::start(const State& state, const Motion& velocity, const Motion& acceleration, double t) {
    t_ = t;
    known_ = 0;
    pack(state, velocity, system_->moving_bodies(), y_.data());
    // unsound rows would be declined later anyway, and it takes time to choose rows of many loops
    if (!equations_->rows_are_sound(t, y_.data())) { return false; }
    equations_->choose_rows(t, y_.data());
    if (equations_->rows() - equations_->rows_left_out() != system_->columns(3)) { return false; }
    const RowsVerdict verdict = equations_->evaluate(t, y_.data(), y_dot_.data());
    // earlier results are kept: they may be better than those of the rows chosen here
    std::size_t n = 0;
    for (const int body : system_->moving_bodies()) {
        const auto b = static_cast<std::size_t>(body);
        double* rates = body_numbers(y_dot_.data(), n++);
        vec3(rates + 7) = acceleration.r_dot[b];
        vec3(rates + 10) = acceleration.omega_local[b];
    }
    return is_sound(verdict);
}

bool DrivenFrames::led_on() const {
    return is_on_tangent(movement(y_, y_new_, length_), movement(predicted_, y_new_, length_));
}

/// Stores the interpolated numbers and their derivatives at the pose from which the next advance starts.
void DrivenFrames::remember() {
    if (known_ > 0 && latest_.back().t == t_) { return; }
    std::ranges::rotate(latest_, latest_.begin() + 1);
    known_ = std::min(known_ + 1, latest_.size());
    latest_.back().t = t_;
    latest_.back().known.resize(equations_->interpolated(), 3);
    equations_->derivatives(y_.data(), y_dot_.data(), latest_.back().known.data());
}

/// Predicts the pose at `t` by the polynomial through the latest poses: of order 9 after three, and of order
/// 6 or 3 if poses are too near to each other for this step.
void DrivenFrames::predict(double t) {
    std::size_t used = 1;
    const auto is_apart = [&](double other) {
        const auto taken = std::span(latest_).last(used);
        return std::ranges::all_of(taken, [&](const HermitePolynomial::Node& node) {
            return std::abs(t - t_) < kMostContinued * std::abs(node.t - other);
        });
    };
    while (used < known_ && is_apart(latest_.end()[-1 - static_cast<std::ptrdiff_t>(used)].t)) { ++used; }
    path_.fit(std::span(latest_).last(used), HermitePolynomial::Meets::second_derivatives_too);
    path_.evaluate(t);
    equations_->state_of(path_.value().data(), path_.rate().data(), predicted_.data());
}

bool DrivenFrames::advance(double t) {
    remember();
    predict(t);
    y_new_ = predicted_;
    const bool is_near = equations_->project(t, y_new_.data()) <= kNear && !equations_->masses_are_apart();
    const RowsVerdict verdict = is_near ? equations_->evaluate_driven(t, y_new_.data(), y_dot_new_.data())
                                        : equations_->evaluate(t, y_new_.data(), y_dot_new_.data());
    if (!is_sound(verdict) || !led_on()) { return false; }
    if (!is_near) { equations_->refine(y_dot_new_.data()); }
    std::swap(y_, y_new_);
    std::swap(y_dot_, y_dot_new_);
    t_before_ = std::exchange(t_, t);
    return true;
}

void DrivenFrames::retreat() {
    std::swap(y_, y_new_);
    std::swap(y_dot_, y_dot_new_);
    t_ = t_before_;
}

void DrivenFrames::write(State& state, Motion& velocity, Motion& acceleration) const {
    unpack(y_.data(), system_->moving_bodies(), state, velocity);
    std::size_t n = 0;
    for (const int body : system_->moving_bodies()) {
        const auto b = static_cast<std::size_t>(body);
        const double* rates = body_numbers(y_dot_.data(), n++);
        acceleration.r_dot[b] = vec3(rates + 7);
        acceleration.omega_local[b] = vec3(rates + 10);
    }
}

}  // namespace jw
