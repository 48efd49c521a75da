#include "core/dynamics/semi_implicit.hpp"

#include <algorithm>
#include <cmath>

namespace jw {

SemiImplicitEuler::SemiImplicitEuler(
    MotionEquations& equations, const IntegrationOptions& options, double t, std::vector<double> y)
    : equations_(&equations), options_(options), t_(t), y_(std::move(y)), y_dot_(y_.size()) {
    equations_->choose_rows(t_, y_.data());
    if (options_.project) { equations_->project(t_, y_.data()); }
    equations_->evaluate(t_, y_.data(), y_dot_.data());
    ++counts_.evaluations;
}

bool SemiImplicitEuler::step(double t_end) {
    const StepAhead ahead(t_, t_end, options_.fixed_step);
    const double h = ahead.h;
    for (std::size_t body = 0; body < y_.size(); body += kNumbersPerBody) {
        double* y = y_.data() + body;
        const double* y_dot = y_dot_.data() + body;
        for (int k = 7; k < kNumbersPerBody; ++k) { y[k] += h * y_dot[k]; }
        vec3(y) += h * vec3(y + 7);
        // a turn by h ω': p stays unit
        vec4(y + 3) = turned_local(vec4(y + 3), h * vec3(y + 10));
    }
    t_ = ahead.end;
    if (options_.project) {
        equations_->project(t_, y_.data());
        ++counts_.projections;
    }
    equations_->evaluate(t_, y_.data(), y_dot_.data());
    ++counts_.evaluations;
    ++counts_.steps;
    return true;
}

}  // namespace jw
