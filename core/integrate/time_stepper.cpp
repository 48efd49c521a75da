#include "core/integrate/time_stepper.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/elementary/elementary.hpp"

namespace jw {

using Kind = NumberScale::Kind;

IntegrationCounts& IntegrationCounts::operator+=(const IntegrationCounts& other) {
    steps += other.steps;
    rejected += other.rejected;
    evaluations += other.evaluations;
    projections += other.projections;
    jacobians += other.jacobians;
    row_choices += other.row_choices;
    singular_passages += other.singular_passages;
    return *this;
}

StepAhead::StepAhead(double t, double t_end, double wanted) {
    const double left = t_end - t;
    // a remainder that is only rounding does not get a separate step
    last = wanted >= left * (1.0 - 1e-12);
    h = last ? left : std::min(wanted, 0.5 * left);
    end = last ? t_end : t + h;
}

StateScales::StateScales(const IntegrationOptions& options, std::vector<NumberScale> numbers)
    : length_(options.length_scale),
      slowest_(1.0 / options.duration),
      numbers_(std::move(numbers)),
      scale_(numbers_.size(), 1.0) {}

/// Largest of the numbers of a kind, each times its weight.
double StateScales::largest(const std::vector<double>& y, NumberScale::Kind kind) const {
    double most = 0.0;
    for (std::size_t k = 0; k < y.size(); ++k) {
        if (numbers_[k].kind == kind) { most = std::max(most, numbers_[k].weight * std::abs(y[k])); }
    }
    return most;
}

void StateScales::include(const std::vector<double>& y, const std::vector<double>& y_dot, double step) {
    // starting from rest, the speed reached within the step counts
    const auto speed = [&](Kind kind) {
        return std::max(largest(y, kind), 0.5 * step * largest(y_dot, kind));
    };
    velocity_ = std::max(velocity_, speed(Kind::velocity));
    omega_ = std::max(omega_, speed(Kind::omega));
    // rotations are compared with the speed of points one length away, and vice versa
    velocity_ = std::max({velocity_, omega_ * length_, slowest_ * length_});
    omega_ = std::max(omega_, velocity_ / length_);
    for (std::size_t k = 0; k < scale_.size(); ++k) {
        scale_[k] = size_of(numbers_[k].kind) / numbers_[k].weight;
    }
}

double StateScales::difference(const double* y, const double* other) const {
    double most = 0.0;
    for (std::size_t k = 0; k < scale_.size(); ++k) {
        const double d = std::abs(y[k] - other[k]) / scale_[k];
        // NaN counts as the largest difference
        if (!(d <= most)) { most = d; }
    }
    return most;
}

double StateScales::way(const double* y, const double* other) const {
    double most = 0.0;
    for (std::size_t k = 0; k < scale_.size(); ++k) {
        const bool of_pose = numbers_[k].kind == Kind::way || numbers_[k].kind == Kind::turn;
        if (of_pose) { most = std::max(most, std::abs(y[k] - other[k]) / scale_[k]); }
    }
    return most;
}

double StateScales::size_of(Kind kind) const {
    switch (kind) {
        case Kind::way: return length_;
        case Kind::turn: return 1.0;
        case Kind::velocity: return velocity_;
        case Kind::omega: break;
    }
    return omega_;
}

double StateScales::first_step(const std::vector<double>& y_dot, double tolerance, int order) const {
    const double acceleration =
        std::max(largest(y_dot, Kind::velocity) / length_, largest(y_dot, Kind::omega));
    const double rate = std::max({slowest_, velocity_ / length_, omega_, std::sqrt(acceleration)});
    return 0.5 * elementary::pow(tolerance, 1.0 / order) / rate;
}

double fastest_turn(const StateLayout& equations, const double* y, std::vector<double>& flat) {
    flat.resize(at(kNumbersPerBody * equations.bodies()));
    equations.to_flat(y, flat.data());
    double most = 0.0;
    for (int n = 0; n < equations.bodies(); ++n) {
        most = std::max(most, vec3(body_numbers(flat.data(), at(n)) + 10).norm());
    }
    return most;
}

}  // namespace jw
