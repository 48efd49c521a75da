#include "core/dynamics/radau.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Eigenvalues>

namespace jw {

namespace {

constexpr int kMostAttempts = 60;
constexpr int kMostIterations = 10;
/// Contraction of Newton's iteration that makes a new Jacobian worth its evaluations.
constexpr double kSlowContraction = 0.1;
/// Contraction with which a longer step would not converge.
constexpr double kNearlyFailed = 0.3;

/// Nodes of Radau IIA on (0, 1]: the zeros of P_s - P_(s-1), by bisection.
VectorX radau_nodes(int stages) {
    VectorX c(stages);
    const auto legendre = [](int n, double x) {
        double before = 1.0;
        double now = x;
        for (int k = 1; k < n; ++k) {
            const double next = ((2 * k + 1) * x * now - k * before) / (k + 1);
            before = now;
            now = next;
        }
        return n == 0 ? 1.0 : now;
    };
    const auto value = [&](double x) { return legendre(stages, x) - legendre(stages - 1, x); };
    for (int i = 0; i < stages - 1; ++i) {
        // each of these intervals holds exactly one
        double left = -std::cos(std::numbers::pi * i / (stages - 0.5));
        double right = -std::cos(std::numbers::pi * (i + 1) / (stages - 0.5));
        const bool rising = value(left) < 0.0;
        for (int k = 0; k < 200; ++k) {
            const double middle = 0.5 * (left + right);
            ((value(middle) < 0.0) == rising ? left : right) = middle;
        }
        c(i) = 0.5 * (1.0 + 0.5 * (left + right));
    }
    c(stages - 1) = 1.0;
    return c;
}

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

RadauTable radau_table(int stages) {
    RadauTable table;
    table.c = radau_nodes(stages);
    // a integrates every polynomial below degree s exactly from 0 to c_i: a V = C, V and C of powers
    MatrixX powers(stages, stages);
    MatrixX integrals(stages, stages);
    for (int i = 0; i < stages; ++i) {
        for (int k = 0; k < stages; ++k) {
            powers(i, k) = std::pow(table.c(i), k);
            integrals(i, k) = std::pow(table.c(i), k + 1) / (k + 1);
        }
    }
    table.a = powers.transpose().fullPivLu().solve(integrals.transpose()).transpose();
    for (const auto& eigenvalue : table.a.eigenvalues()) {
        if (std::abs(eigenvalue.imag()) < 1e-9) { table.gamma_0 = eigenvalue.real(); }
    }
    // quadrature of order s with the node 0 besides, weight gamma_0
    VectorX moments(stages);
    for (int k = 0; k < stages; ++k) { moments(k) = 1.0 / (k + 1) - (k == 0 ? table.gamma_0 : 0.0); }
    const VectorX b_hat = powers.transpose().fullPivLu().solve(moments);
    const VectorX b = table.a.row(stages - 1).transpose();
    table.e = table.a.transpose().fullPivLu().solve(b_hat - b);
    return table;
}

RadauIntegrator::RadauIntegrator(
    MotionEquations& equations, std::unique_ptr<ReducedCoordinates> coordinates, int stages,
    const IntegrationOptions& options, double t, std::vector<double> y)
    : equations_(&equations),
      table_(radau_table(stages)),
      options_(options),
      scales_(options.length_scale, equations.scales()),
      t_(t),
      y_(std::move(y)),
      y_dot_(y_.size()),
      coordinates_(std::move(coordinates)) {
    equations_->choose_rows(t_, y_.data());
    equations_->project(t_, y_.data());
    equations_->evaluate(t_, y_.data(), y_dot_.data());
    counts_.projections = counts_.evaluations = 1;
    scales_.include(y_, y_dot_, 0.0);
    h_ = options_.fixed_step > 0.0 ? options_.fixed_step
                                   : scales_.first_step(y_dot_, options_.tolerance, stages + 1);
    scales_.include(y_, y_dot_, h_);
    const auto size = static_cast<Eigen::Index>(y_.size());
    y_stages_ = MatrixX::Zero(size, stages);
    y_rate_ = VectorX::Zero(size);
    choose_coordinates();
}

/// What was known of the last step in other coordinates is of no use any more.
void RadauIntegrator::choose_coordinates() {
    x_ = coordinates_->choose(t_, y_.data());
    x_dot_ = VectorX::Zero(x_.size());
    coordinates_->evaluate(t_, x_, y_.data(), y_dot_.data(), x_dot_);
    x_scale_ = coordinates_->sizes(scales_);
    x_stages_ = x_rates_ = MatrixX::Zero(x_.size(), table_.c.size());
    step_before_ = 0.0;
    reduced_.resize(0, 0);
}

bool RadauIntegrator::jacobian_is_stale() const {
    return reduced_.size() == 0 || contraction_ > kSlowContraction;
}

void RadauIntegrator::renew_jacobian() {
    ++counts_.jacobians;
    const Eigen::Index n = x_.size();
    VectorX moved(n);
    VectorX rate(n);
    VectorX y(y_rate_.size());
    reduced_.resize(n, n);
    for (Eigen::Index k = 0; k < n; ++k) {
        // forward differences lose half the digits whatever the step; this is the middle
        const double step = 1e-8 * x_scale_(k);
        moved = x_;
        moved(k) += step;
        y = Eigen::Map<const VectorX>(y_.data(), y.size());
        coordinates_->evaluate(t_, moved, y.data(), y_rate_.data(), rate);
        reduced_.col(k) = (rate - x_dot_) / step;
    }
    counts_.evaluations += n;
    counts_.projections += n;
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

/// Stages to start from: the polynomial of the last step, continued.
void RadauIntegrator::predict(double h) {
    for (Eigen::Index i = 0; i < x_stages_.cols(); ++i) {
        if (step_before_ == 0.0) {
            x_stages_.col(i) = x_;
            y_stages_.col(i) = Eigen::Map<const VectorX>(y_.data(), y_rate_.size());
        } else {
            const VectorX w = weights(1.0 + table_.c(i) * h / step_before_);
            x_stages_.col(i) = x_before_ * w;
            y_stages_.col(i) = y_before_ * w;
        }
    }
}

double RadauIntegrator::norm(const VectorX& change) const {
    return change.cwiseQuotient(x_scale_).norm() / std::sqrt(static_cast<double>(change.size())) /
           options_.tolerance;
}

RadauIntegrator::NewtonEnd RadauIntegrator::solve_stages(double h) {
    const Eigen::Index stages = table_.c.size();
    const Eigen::Index n = reduced_.rows();
    // what is left of the iteration shall not be seen in the error of the step
    const double enough = std::max(1e-15 / options_.tolerance, std::min(0.03, std::sqrt(options_.tolerance)));
    NewtonEnd end;
    double last = 0.0;
    for (end.iterations = 1; end.iterations <= kMostIterations; ++end.iterations) {
        for (Eigen::Index i = 0; i < stages; ++i) {
            coordinates_->evaluate(
                t_ + table_.c(i) * h, x_stages_.col(i), y_stages_.col(i).data(), y_rate_.data(),
                x_rates_.col(i));
        }
        counts_.evaluations += stages;
        counts_.projections += stages;
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
            if (end.contraction >= 0.99) { return end; }
            const double left = end.contraction / (1.0 - end.contraction) * size;
            end.converged = left <= enough;
            const int more = kMostIterations - end.iterations;
            if (end.converged || left * std::pow(end.contraction, more - 1) > enough) { return end; }
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
    // what stiff parts of the first estimate exaggerate is damped by a second one
    VectorX y = Eigen::Map<const VectorX>(y_.data(), y_rate_.size());
    VectorX rate(x_.size());
    coordinates_->evaluate(t_, x_ + error, y.data(), y_rate_.data(), rate);
    ++counts_.evaluations;
    return norm(filtered(rate));
}

void RadauIntegrator::accept(double h, double t) {
    const Eigen::Index stages = x_stages_.cols();
    x_before_.resize(x_.size(), stages + 1);
    y_before_.resize(y_rate_.size(), stages + 1);
    x_before_ << x_, x_stages_;
    y_before_ << Eigen::Map<const VectorX>(y_.data(), y_rate_.size()), y_stages_;
    step_before_ = last_step_ = h;
    t_ = t;
    x_ = x_stages_.col(stages - 1);
    std::copy_n(y_stages_.col(stages - 1).data(), y_.size(), y_.data());
    coordinates_->evaluate(t_, x_, y_.data(), y_dot_.data(), x_dot_);
    ++counts_.evaluations;
    ++counts_.steps;
    scales_.include(y_, y_dot_, 0.0);
    x_scale_ = coordinates_->sizes(scales_);
    if (!coordinates_->is_sound()) { choose_coordinates(); }
}

bool RadauIntegrator::step(double t_end) {
    bool doubtful = step_before_ == 0.0;
    double most_growth = most_growth_;
    most_growth_ = 6.0;
    bool renewed = jacobian_is_stale();
    if (renewed) { renew_jacobian(); }
    for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
        const StepAhead ahead(t_, t_end, h_);
        const double h = ahead.h;
        factor(h);
        predict(h);
        const NewtonEnd newton = solve_stages(h);
        if (!newton.converged) {
            ++counts_.rejected;
            if (renewed) { h_ = 0.5 * h; }
            // what Newton's iteration could not do now it cannot do in the next steps either
            most_growth = most_growth_ = 1.0;
            if (!renewed) { renew_jacobian(); }
            renewed = true;
            continue;
        }
        contraction_ = newton.contraction;
        const double error = options_.fixed_step > 0.0 ? 0.0 : error_of(h, doubtful);
        const double safety = 0.9 * (2 * kMostIterations + 1) / (2 * kMostIterations + newton.iterations);
        const double order = static_cast<double>(x_stages_.cols()) + 1.0;
        const double growth =
            error > 0.0 ? std::clamp(safety * std::pow(error, -1.0 / order), 0.2, 6.0) : 6.0;
        if (error > 1.0) {
            ++counts_.rejected;
            doubtful = true;
            h_ = h * std::min(growth, 0.9);
            continue;
        }
        accept(h, ahead.end);
        if (options_.fixed_step > 0.0 || ahead.last) { return true; }
        const double slow = newton.contraction > kNearlyFailed ? 1.0 : most_growth;
        const double wanted = std::min(growth, doubtful ? 1.0 : slow);
        // the factors of this step serve the next one too
        h_ = wanted >= 1.0 && wanted <= 1.2 ? h : h * wanted;
        return true;
    }
    return false;
}

bool RadauIntegrator::interpolate(double t, double* y) const {
    if (last_step_ == 0.0) { return false; }
    const VectorX at = y_before_ * weights(1.0 - (t_ - t) / last_step_);
    std::copy_n(at.data(), at.size(), y);
    return true;
}

}  // namespace jw
