#include "core/kinematics/driven_frames.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/motion/flat_state.hpp"
#include "core/poses/branches.hpp"

namespace jw {

namespace {

/// Least squared part of a row that must be independent of the others. Measured on Bennett's mechanism near
/// its folded position: accelerations are then good to 1e-13, and lose a digit for every digit below.
constexpr double kLeastPivot = kSurelyIndependent;
/// Rounding of Φ by the size of its equations; rows that repeat others but contradict them are above it.
constexpr double kHolds = 1e-13;

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
    has_before_ = false;
    pack(state, velocity, system_->moving_bodies(), y_.data());
    // others would be declined in the end; rows of many loops take their time to be chosen
    if (!equations_->rows_are_sound(t, y_.data())) { return false; }
    equations_->choose_rows(t, y_.data());
    if (equations_->rows() - equations_->rows_left_out() != system_->columns(3)) { return false; }
    const RowsVerdict verdict = equations_->evaluate(t, y_.data(), y_dot_.data());
    // results found by others stay: they may be better than those of the rows kept here
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

/// Predicts the pose at `t`. Where ω' changes its direction, the turn is more than the integral of its
/// components: by h³/12 ω' × ω̇' to third order.
void DrivenFrames::predict(double t) {
    const double h = t - t_;
    const double since = has_before_ && t_ != t_before_ ? 1.0 / (t_ - t_before_) : 0.0;
    predicted_ = y_;
    for (std::size_t k = 0; k < y_.size(); k += kNumbersPerBody) {
        double* y = &predicted_[k];
        double six[6];
        const Vec3 omega = vec3(y + 10);
        const Vec3 around = omega.cross(vec3(&y_dot_[k + 10]));
        for (std::size_t c = 0; c < 6; ++c) {
            const double rate = y_dot_[k + 7 + c];
            const double change = since * (rate - y_dot_new_[k + 7 + c]);
            six[c] = h * (y[7 + c] + h * (rate / 2.0 + h * change / 6.0));
            y[7 + c] += h * (rate + h * change / 2.0);
        }
        vec3(six + 3) += h * h * h / 12.0 * around;
        displace(y, six, 1);
    }
}

bool DrivenFrames::advance(double t) {
    predict(t);
    has_before_ = false;
    y_new_ = predicted_;
    equations_->project(t, y_new_.data());
    const RowsVerdict verdict = equations_->evaluate(t, y_new_.data(), y_dot_new_.data());
    if (!is_sound(verdict) || !led_on()) { return false; }
    equations_->refine(y_dot_new_.data());
    std::swap(y_, y_new_);
    std::swap(y_dot_, y_dot_new_);
    t_before_ = std::exchange(t_, t);
    has_before_ = true;
    return true;
}

void DrivenFrames::retreat() {
    std::swap(y_, y_new_);
    std::swap(y_dot_, y_dot_new_);
    t_ = t_before_;
    has_before_ = false;
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
