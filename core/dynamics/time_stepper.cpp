#include "core/dynamics/time_stepper.hpp"

#include <algorithm>
#include <cmath>

namespace jw {

StepAhead::StepAhead(double t, double t_end, double wanted) {
    const double left = t_end - t;
    // what rounding left over is no step of its own
    last = wanted >= left * (1.0 - 1e-12);
    h = last ? left : std::min(wanted, 0.5 * left);
    end = last ? t_end : t + h;
}

/// Largest of the numbers c in [from, to) of all bodies.
double StateScales::largest(const std::vector<double>& y, std::size_t from, std::size_t to) const {
    double most = 0.0;
    for (std::size_t k = 0; k < y.size(); k += numbers_) {
        for (std::size_t c = from; c < to; ++c) { most = std::max(most, std::abs(y[k + c])); }
    }
    return most;
}

void StateScales::include(const std::vector<double>& y, const std::vector<double>& y_dot, double step) {
    // from rest the speed reached within a step counts
    velocity_ = std::max({velocity_, largest(y, 7, 10), 0.5 * step * largest(y_dot, 7, 10)});
    omega_ = std::max({omega_, largest(y, 10, numbers_), 0.5 * step * largest(y_dot, 10, numbers_)});
    // what only turns is compared with the speed of points one length away, and the other way round
    constexpr double still = 1e-300;  // of a scene where nothing moves and nothing will
    velocity_ = std::max({velocity_, omega_ * length_, still});
    omega_ = std::max(omega_, velocity_ / length_);
}

double StateScales::first_step(const std::vector<double>& y_dot, double tolerance, int order) const {
    constexpr double slowest = 1e-3;  // [1/s], of a scene at rest without forces
    const double acceleration = std::max(largest(y_dot, 7, 10) / length_, largest(y_dot, 10, numbers_));
    const double rate = std::max({slowest, velocity_ / length_, omega_, std::sqrt(acceleration)});
    return 0.5 * std::pow(tolerance, 1.0 / order) / rate;
}

}  // namespace jw
