#include "core/integrate/semi_implicit.hpp"

#include "core/equations/constraint_rounding.hpp"

namespace jw {

SemiImplicitEuler::SemiImplicitEuler(
    MotionEquations& equations, const IntegrationOptions& options, double t, std::vector<double> y)
    : equations_(&equations), options_(options), t_(t), y_(std::move(y)), y_dot_(y_.size()) {
    equations_->begin_turns(t_, y_.data());
    equations_->choose_rows(t_, y_.data());
    if (options_.project) { equations_->project(t_, y_.data()); }
    equations_->evaluate(t_, y_.data(), y_dot_.data());
    ++counts_.evaluations;
}

bool SemiImplicitEuler::step(double t_end) {
    if (options_.project && verdict_.left_out > kContradicts) { return false; }
    const StepAhead ahead(t_, t_end, options_.fixed_step);
    const double h = ahead.h;
    y_new_ = y_;
    for (std::size_t body = 0; body < y_.size(); body += kNumbersPerBody) {
        double* y = y_new_.data() + body;
        const double* y_dot = y_dot_.data() + body;
        for (int k = 7; k < kNumbersPerBody; ++k) { y[k] += h * y_dot[k]; }
        vec3(y) += h * vec3(y + 7);
        // rotation by h ω': p stays unit
        vec4(y + 3) = turned_local(vec4(y + 3), h * vec3(y + 10));
    }
    tried_ = ahead.end;
    if (options_.project) {
        equations_->project(tried_, y_new_.data());
        ++counts_.projections;
    }
    verdict_ = equations_->evaluate(tried_, y_new_.data(), y_dot_.data());
    ++counts_.evaluations;
    // NaN is reported by another check
    if (options_.project && verdict_.violation > kMet) { return false; }
    std::swap(y_, y_new_);
    t_ = tried_;
    equations_->follow_turns(t_, y_.data());
    ++counts_.steps;
    return true;
}

}  // namespace jw
