#include "core/integrate/radau.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/elementary/elementary.hpp"
#include "core/motion/singular_steps.hpp"

namespace jw {

namespace {

constexpr int kMostAttempts = 60;
constexpr int kMostIterations = 10;
/// Ratio of step lengths up to which the polynomial of the last step predicts y.
constexpr double kFarthest = 2.0;
constexpr int kMostDodges = 12;
/// Pivot of a stage below which a step passes through a singular position: the square of 0.03.
constexpr double kThrough = 1e-3;
/// Share of the last regular step below which a step near a singular position is given up.
constexpr double kGivesUp = 1e-3;
/// Contraction of Newton's iteration from which a new Jacobian is worth its evaluations.
constexpr double kSlowContraction = 0.1;
/// Size of a change, relative to the tolerance, that does not affect a step.
constexpr double kRoundingSeen = 1e-3;
constexpr double kRoundingNear = 0.1;  ///< the same near a singular position, where rounding allows no more
/// Error of a step through a singular position, relative to the tolerance, that is attributed to rounding.
constexpr double kMostRoundingThrough = 10.0;
/// Contraction above which a longer step would not converge.
constexpr double kNearlyFailed = 0.3;

/// Weights w with Σ w_j p(x_j) = p(x) for all polynomials below the number of nodes.
VectorX lagrange_weights(const VectorX& nodes, double x) {
    VectorX weights = VectorX::Ones(nodes.size());
    for (Eigen::Index j = 0; j < nodes.size(); ++j) {
        for (Eigen::Index m = 0; m < nodes.size(); ++m) {
            if (m != j) { weights(j) *= (x - nodes(m)) / (nodes(j) - nodes(m)); }
        }
    }
    return weights;
}

}  // namespace

RadauIntegrator::RadauIntegrator(
    MotionEquations& equations, std::unique_ptr<ReducedCoordinates> coordinates, int stages,
    const IntegrationOptions& options, double t, std::vector<double> y)
    : equations_(&equations),
      table_(radau_table(stages)),
      options_(options),
      scales_(options, equations.scales()),
      t_(t),
      y_(std::move(y)),
      y_dot_(y_.size()),
      coordinates_(std::move(coordinates)) {
    equations_->begin_turns(t_, y_.data());
    equations_->choose_rows(t_, y_.data());
    equations_->project(t_, y_.data());
    equations_->evaluate(t_, y_.data(), y_dot_.data());
    ++counts_.projections;
    ++counts_.evaluations;
    scales_.include(y_, y_dot_, 0.0);
    h_ = options_.fixed_step > 0.0 ? options_.fixed_step
                                   : scales_.first_step(y_dot_, options_.tolerance, stages + 1);
    scales_.include(y_, y_dot_, h_);
    const auto size = static_cast<Eigen::Index>(y_.size());
    y_stages_ = MatrixX::Zero(size, stages);
    y_rates_ = MatrixX::Zero(size, stages);
    choose_coordinates();
}

void RadauIntegrator::evaluate(
    double t, const VectorX& x, double* y, double* y_dot, Eigen::Ref<VectorX> x_dot) {
    coordinates_->evaluate(t, x, y, y_dot, x_dot);
    ++counts_.evaluations;
    if (coordinates_->are_projected()) { ++counts_.projections; }
}

/// Chooses new coordinates; the last step, which is stored in the old ones, is discarded.
void RadauIntegrator::choose_coordinates() {
    x_ = coordinates_->choose(t_, y_.data());
    x_dot_ = VectorX::Zero(x_.size());
    evaluate(t_, x_, y_.data(), y_dot_.data(), x_dot_);
    x_scale_ = coordinates_->sizes(scales_);
    x_stages_ = x_rates_ = MatrixX::Zero(x_.size(), table_.c.size());
    step_before_ = 0.0;
    reduced_.resize(0, 0);
    choose_again_ = false;
}

/// Chooses new coordinates during the motion, with rows that were left out before and are independent now.
/// @return false if those rows move the state: it never satisfied them, so its motion was free to first order
/// only, and a mechanism does not move in this way
bool RadauIntegrator::keeps_its_place() {
    const std::vector<double> before = y_;
    choose_coordinates();
    return scales_.difference(y_.data(), before.data()) <= kOneMotion;
}

bool RadauIntegrator::jacobian_is_stale() const {
    return reduced_.size() == 0 || contraction_ > kSlowContraction;
}

void RadauIntegrator::renew_jacobian() {
    ++counts_.jacobians;
    const Eigen::Index n = x_.size();
    VectorX moved(n);
    VectorX rate(n);
    VectorX y(y_stages_.rows());
    VectorX y_rate(y.size());
    reduced_.resize(n, n);
    for (Eigen::Index k = 0; k < n; ++k) {
        // step of forward differences: the square root of rounding
        const double step = 1e-8 * x_scale_(k);
        moved = x_;
        moved(k) += step;
        y = Eigen::Map<const VectorX>(y_.data(), y.size());
        evaluate(t_, moved, y.data(), y_rate.data(), rate);
        reduced_.col(k) = (rate - x_dot_) / step;
    }
    factored_step_ = 0.0;
}

void RadauIntegrator::factor(double h) {
    if (factored_step_ == h) { return; }
    const Eigen::Index n = reduced_.rows();
    const Eigen::Index stages = table_.c.size();
    MatrixX system = MatrixX::Identity(n * stages, n * stages);
    for (Eigen::Index i = 0; i < stages; ++i) {
        for (Eigen::Index j = 0; j < stages; ++j) {
            system.block(n * i, n * j, n, n) -= h * table_.a(i, j) * reduced_;
        }
    }
    stages_lu_.compute(system);
    error_lu_.compute(MatrixX::Identity(n, n) - h * table_.gamma_0 * reduced_);
    factored_step_ = h;
}

VectorX RadauIntegrator::weights(double tau) const {
    VectorX nodes(table_.c.size() + 1);
    nodes << 0.0, table_.c;
    return lagrange_weights(nodes, tau);
}

/// Initial stages: the polynomial of the last step, extrapolated.
void RadauIntegrator::predict(double h) {
    for (Eigen::Index i = 0; i < x_stages_.cols(); ++i) {
        x_stages_.col(i) = x_;
        y_stages_.col(i) = start_numbers();
        if (step_before_ == 0.0) { continue; }
        const VectorX w = weights(1.0 + table_.c(i) * h / step_before_);
        x_stages_.col(i) = x_before_ * w;
        // far outside its step, a polynomial can lead anywhere, also near another branch
        if (h <= kFarthest * step_before_) { y_stages_.col(i) = y_before_ * w; }
    }
}

double RadauIntegrator::norm(const VectorX& change) const {
    // no freedoms: the drivers determine everything
    if (change.size() == 0) { return 0.0; }
    return change.cwiseQuotient(x_scale_).norm() / std::sqrt(static_cast<double>(change.size())) /
           options_.tolerance;
}

bool RadauIntegrator::NewtonEnd::is_near_singular() const { return pivot_left < kNearSingular; }
bool RadauIntegrator::NewtonEnd::is_too_near() const {
    return std::min(pivot_left, pivot_with_coordinates_left) < kTooNear;
}

/// Effect of the rounding of accelerations on velocities in a step near a singular position, relative to the
/// tolerance.
double RadauIntegrator::rounding_through(double h, double pivot) const {
    return h * scales_.omega() * rounding_of_acceleration(pivot) / options_.tolerance;
}

RadauIntegrator::NewtonEnd RadauIntegrator::solve_stages(double h) {
    const Eigen::Index stages = table_.c.size();
    const Eigen::Index n = reduced_.rows();
    // the remaining error of the iteration must not show in the error of the step
    const double enough = std::max(1e-15 / options_.tolerance, std::min(0.03, std::sqrt(options_.tolerance)));
    NewtonEnd end;
    double last = 0.0;
    for (end.iterations = 1; end.iterations <= kMostIterations; ++end.iterations) {
        end.pivot_left = end.pivot_with_coordinates_left = 1.0;
        end.violation = 0.0;
        for (Eigen::Index i = 0; i < stages; ++i) {
            evaluate(
                t_ + table_.c(i) * h, x_stages_.col(i), y_stages_.col(i).data(), y_rates_.col(i).data(),
                x_rates_.col(i));
            end.pivot_left = std::min(end.pivot_left, coordinates_->pivot_left());
            end.pivot_with_coordinates_left =
                std::min(end.pivot_with_coordinates_left, coordinates_->pivot_with_coordinates_left());
            end.violation = std::max(end.violation, coordinates_->verdict().violation);
        }
        const MatrixX residual = h * x_rates_ * table_.a.transpose() - (x_stages_.colwise() - x_);
        const VectorX change = stages_lu_.solve(Eigen::Map<const VectorX>(residual.data(), residual.size()));
        double size = 0.0;
        for (Eigen::Index i = 0; i < stages; ++i) {
            x_stages_.col(i) += change.segment(n * i, n);
            size = std::max(size, norm(change.segment(n * i, n)));
        }
        if (!std::isfinite(size)) { return end; }
        if (end.iterations > 1) {
            end.contraction = size / last;
            const double rounding = end.is_near_singular()
                                        ? std::max(kRoundingNear, rounding_through(h, end.pivot_left))
                                        : kRoundingSeen;
            if (end.contraction > kSlowContraction && size <= rounding) {
                // this close, only rounding prevents contraction
                end.contraction = kSlowContraction;
                end.converged = true;
                return end;
            }
            if (end.contraction >= 0.99) { return end; }
            const double left = end.contraction / (1.0 - end.contraction) * size;
            const double least = end.is_near_singular() ? std::max(enough, rounding) : enough;
            end.converged = left <= enough;
            const int more = kMostIterations - end.iterations;
            if (end.converged || left * elementary::pow(end.contraction, more - 1) > least) { return end; }
        } else if (size <= 1e-2 * enough) {
            end.converged = true;
            end.contraction = 0.0;
            return end;
        }
        last = size;
    }
    return end;
}

double RadauIntegrator::error_of(double h, bool doubtful) {
    const VectorX of_stages = (x_stages_.colwise() - x_) * table_.e;
    const auto filtered = [&](const VectorX& rate) -> VectorX {
        return error_lu_.solve(table_.gamma_0 * h * rate + of_stages);
    };
    const VectorX error = filtered(x_dot_);
    if (!doubtful || norm(error) < 1.0) { return norm(error); }
    // a second filtering damps stiff components, which are too large in the first estimate
    VectorX y = start_numbers();
    VectorX y_rate(y.size());
    VectorX rate(x_.size());
    evaluate(t_, x_ + error, y.data(), y_rate.data(), rate);
    return norm(filtered(rate));
}

void RadauIntegrator::accept(double h, double t) {
    const Eigen::Index stages = x_stages_.cols();
    x_before_.resize(x_.size(), stages + 1);
    y_before_.resize(y_stages_.rows(), stages + 1);
    x_before_ << x_, x_stages_;
    y_before_ << start_numbers(), y_stages_;
    step_before_ = last_step_ = h;
    t_ = t;
    x_ = x_stages_.col(stages - 1);
    std::copy_n(y_stages_.col(stages - 1).data(), y_.size(), y_.data());
    evaluate(t_, x_, y_.data(), y_dot_.data(), x_dot_);
    coordinates_->follow_turns(t_, y_.data());
    ++counts_.steps;
    scales_.include(y_, y_dot_, 0.0);
    x_scale_ = coordinates_->sizes(scales_);
    const double left_out = coordinates_->verdict().left_out;
    const bool ask_again = left_out > left_out_asked_;
    if (ask_again) { left_out_asked_ = kAskedAgain * left_out; }
    // chosen in the next step: samples within this one still need its coordinates
    choose_again_ = ask_again || !coordinates_->is_sound();
}

/// Prepares another attempt after Newton's iteration failed or a stage lies too near to a singular position.
/// @return false if there is no more to try
bool RadauIntegrator::try_otherwise(double h, const NewtonEnd& newton, Trial& trial) {
    ++counts_.rejected;
    if (newton.is_near_singular() && !newton.converged && !trial.without_slope) {
        // slopes of accelerations are unbounded at the singular position and do not describe the step
        trial.without_slope = true;
        reduced_.setZero();
        factored_step_ = 0.0;
        return true;
    }
    if (newton.is_near_singular() && trial.dodges < kMostDodges) {
        // shorter steps would only find the singular position; another length steps over it
        ++trial.dodges;
        h_ = kDodge * h;
        return true;
    }
    // small steps towards the singular position do not lead past it: accelerations there are rounding errors
    if (newton.is_near_singular() && h < kGivesUp * regular_step_) { return false; }
    if (trial.renewed) { h_ = 0.5 * h; }
    // a step that did not converge now would not converge in the next steps either
    trial.most_growth = most_growth_ = 1.0;
    if (!trial.renewed) { renew_jacobian(); }
    trial.renewed = true;
    return true;
}

double RadauIntegrator::growth_after(double error, int iterations) const {
    constexpr double most = 6.0;
    const double safety = 0.9 * (2 * kMostIterations + 1) / (2 * kMostIterations + iterations);
    const double order = static_cast<double>(x_stages_.cols()) + 1.0;
    return error > 0.0 ? std::clamp(safety * elementary::pow(error, -1.0 / order), 0.2, most) : most;
}

bool RadauIntegrator::step(double t_end) {
    const bool fixed = options_.fixed_step > 0.0;
    if (coordinates_->verdict().left_out > std::max(kContradicts, options_.tolerance)) { return false; }
    if (choose_again_ && !keeps_its_place()) { return false; }
    Trial trial;
    trial.doubtful = step_before_ == 0.0;
    trial.renewed = jacobian_is_stale();
    trial.most_growth = most_growth_;
    most_growth_ = 6.0;
    if (trial.renewed) { renew_jacobian(); }
    for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
        const double turn_rate = fastest_turn(*equations_, y_.data(), flat_);
        if (!fixed && turn_rate * h_ > most_turn()) { h_ = most_turn() / turn_rate; }
        h_ = std::min(h_, options_.longest_step);
        const StepAhead ahead(t_, t_end, h_);
        const double h = ahead.h;
        factor(h);
        predict(h);
        const NewtonEnd newton = solve_stages(h);
        tried_ = ahead.end;
        // where no state satisfies the equations, a shorter step may stay within reach
        if (!newton.converged || newton.is_too_near() || newton.violation > kMet) {
            if (!try_otherwise(h, newton, trial)) { return false; }
            continue;
        }
        if (!fixed && turned_too_far(h)) {
            ++counts_.rejected;
            continue;
        }
        if (!fixed && !is_one_motion(h)) {
            ++counts_.rejected;
            h_ = 0.5 * h;
            continue;
        }
        contraction_ = newton.contraction;
        const double error = fixed ? 0.0 : error_of(h, trial.doubtful);
        const double growth = growth_after(error, newton.iterations);
        const bool singular = newton.is_near_singular();
        // the error estimate of a step through a singular position is rounding, not an error of the motion
        const bool through = newton.pivot_left < kThrough;
        const double most_error =
            std::max(kMostRoundingThrough, 30.0 * rounding_through(h, newton.pivot_left));
        const bool small_enough = through && h <= kSmallestShare * regular_step_ && error < most_error;
        if (error > 1.0 && !small_enough) {
            ++counts_.rejected;
            trial.doubtful = true;
            h_ = h * std::min(growth, 0.9);
            continue;
        }
        accept(h, ahead.end);
        if (singular) { ++counts_.singular_passages; }
        if (trial.without_slope) { reduced_.resize(0, 0); }
        if (!singular && !ahead.last) { regular_step_ = h; }
        if (fixed || ahead.last) { return true; }
        const double slow = newton.contraction > kNearlyFailed ? 1.0 : trial.most_growth;
        const double wanted = std::min(growth, trial.doubtful ? 1.0 : slow);
        // keeps h, so that the factors of this step serve the next one too
        h_ = wanted >= 1.0 && wanted <= 1.2 ? h : h * wanted;
        if (singular) { h_ = std::max(h_, kSmallestShare * regular_step_); }
        return true;
    }
    return false;
}

}  // namespace jw
