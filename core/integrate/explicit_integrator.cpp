#include "core/integrate/explicit_integrator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/elementary/elementary.hpp"
#include "core/motion/singular_steps.hpp"

namespace jw {

namespace {

constexpr int kMostAttempts = 60;
/// Step-size control; kMemory is the exponent of the previous error.
constexpr double kSafety = 0.9;
constexpr double kMostGrowth = 3.0;
constexpr double kMemory = 0.05;
/// Ratio of the pivot to that of the last choice below which rows are chosen again.
constexpr double kRowsTurnBad = 1e-2;
constexpr int kMostDodges = 8;
/// Allowed drift off the constraints, as a share of the tolerance.
constexpr double kDriftShare = 0.1;
/// Share of the longest step so far below which a step does not make progress towards the limit of reach,
/// where accelerations grow beyond bounds.
constexpr double kNoProgress = 1e-6;

}  // namespace

ExplicitIntegrator::ExplicitIntegrator(
    MotionEquations& equations, const RungeKuttaTable& table, const IntegrationOptions& options, double t,
    std::vector<double> y)
    : equations_(&equations),
      table_(&table),
      options_(options),
      scales_(options, equations.scales()),
      stiffness_(table),
      t_(t),
      y_(std::move(y)),
      y_new_(y_.size()),
      y_dot_new_(y_.size()),
      stages_(static_cast<std::size_t>(table.stages), std::vector<double>(y_.size())) {
    equations_->begin_turns(t_, y_.data());
    equations_->choose_rows(t_, y_.data());
    if (options_.project) { project(t_, y_); }
    verdict_ = evaluate(t_, y_, stages_.front());
    pivot_at_choice_ = regular_pivot_ = verdict_.smallest_pivot;
    scales_.include(y_, stages_.front(), 0.0);
    h_ = is_fixed() ? options_.fixed_step
                    : scales_.first_step(stages_.front(), options_.tolerance, table_->order);
    scales_.include(y_, stages_.front(), h_);
    start_ = y_;
}

/// Evaluates ẏ at y, which is projected first if `on_manifold_` is set.
RowsVerdict ExplicitIntegrator::evaluate(double t, std::vector<double>& y, std::vector<double>& y_dot) {
    if (on_manifold_) { project(t, y); }
    ++counts_.evaluations;
    return equations_->evaluate(t, y.data(), y_dot.data());
}

void ExplicitIntegrator::project(double t, std::vector<double>& y) {
    equations_->project(t, y.data());
    ++counts_.projections;
}

double ExplicitIntegrator::error_of(double h) const {
    double sum = 0.0;
    double sum_third = 0.0;
    for (std::size_t k = 0; k < y_.size(); ++k) {
        double error = 0.0;
        double third = 0.0;
        for (std::size_t s = 0; s < stages_.size(); ++s) {
            error += table_->e[s] * stages_[s][k];
            third += table_->e_third[s] * stages_[s][k];
        }
        const double scale = scales_.of(k);
        sum += (error / scale) * (error / scale);
        sum_third += (third / scale) * (third / scale);
    }
    const double count = static_cast<double>(y_.size());
    if (y_.empty()) { return 0.0; }
    if (sum_third == 0.0) { return std::abs(h) * std::sqrt(sum / count) / options_.tolerance; }
    return std::abs(h) * sum / std::sqrt((sum + 0.01 * sum_third) * count) / options_.tolerance;
}

void ExplicitIntegrator::take_step(double h) {
    const RungeKuttaTable& table = *table_;
    lowest_pivot_ = verdict_.smallest_pivot;
    const auto add = [&](std::vector<double>& y, double factor, std::size_t stage) {
        if (factor == 0.0) { return; }
        const double* k = stages_[stage].data();
        for (std::size_t n = 0; n < y.size(); ++n) { y[n] += factor * k[n]; }
    };
    const auto stages = static_cast<std::size_t>(table.stages);
    for (std::size_t s = 1; s < stages; ++s) {
        y_new_ = y_;
        for (std::size_t m = 0; m < s; ++m) { add(y_new_, h * table.a[s][m], m); }
        const RowsVerdict verdict = evaluate(t_ + table.c[s] * h, y_new_, stages_[s]);
        if (stiffness_.wants(s)) { stiffness_.keep(y_new_); }
        lowest_pivot_ = std::min(lowest_pivot_, verdict.smallest_pivot);
        verdict_of_last_stage_ = verdict;
    }
    y_new_ = y_;
    for (std::size_t s = 0; s < stages; ++s) { add(y_new_, h * table.b[s], s); }
    // the end is the first stage of the next step: it must not be too near to a singular position either
    verdict_new_ = evaluate_end(t_ + h);
    lowest_pivot_ = std::min(lowest_pivot_, verdict_new_.smallest_pivot);
}

/// Evaluates ẏ at the end of a step, which is projected if it has drifted. Fixed steps have no tolerance to
/// compare the drift with; their ends are always projected.
RowsVerdict ExplicitIntegrator::evaluate_end(double t) {
    const bool always = options_.project && (is_fixed() || on_manifold_);
    if (on_manifold_) {
        correct_end(t);
    } else if (always) {
        project(t, y_new_);
    }
    const auto evaluated = [&] {
        ++counts_.evaluations;
        return equations_->evaluate(t, y_new_.data(), y_dot_new_.data());
    };
    const bool is_known = table_->is_first_same_as_last() && !always;
    if (is_known) { y_dot_new_ = stages_.back(); }
    const RowsVerdict verdict = is_known ? verdict_of_last_stage_ : evaluated();
    // near a singular position a residual is a larger error of the motion: its rates are wrong by 1 / pivot
    const double soft = std::min(1.0, verdict.smallest_pivot / (kNearSingular * regular_pivot_));
    const double drift = kDriftShare * options_.tolerance;
    const double allowed = std::max(soft * drift, std::min(kNearlyExact, drift));
    if (!options_.project || always || verdict.violation <= allowed) { return verdict; }
    project(t, y_new_);
    return evaluated();
}

/// Projects the end of a step near a singular position; the distance shows whether it stayed on its branch.
void ExplicitIntegrator::correct_end(double t) {
    std::vector<double>& before = y_dot_new_;  // free until the end is evaluated
    before = y_new_;
    project(t, y_new_);
    correction_ = 0.0;
    for (std::size_t k = 0; k < y_new_.size(); ++k) {
        correction_ = std::max(correction_, std::abs(y_new_[k] - before[k]) / scales_.of(k));
    }
}

/// Makes the end of the step the start of the next.
void ExplicitIntegrator::accept(double t) {
    t_ = t;
    std::swap(y_, y_new_);
    std::swap(stages_.front(), y_dot_new_);
    verdict_ = verdict_new_;
    equations_->follow_turns(t_, y_.data());
    ++counts_.steps;
    scales_.include(y_, stages_.front(), 0.0);
    if (options_.project && equations_->rows_left_out() > 0) {
        verdict_.left_out = equations_->violation(t_, y_.data()).first;
    }
    if (equations_->follow_rule(t_, y_.data())) {
        verdict_ = evaluate(t_, y_, stages_.front());
        pivot_at_choice_ = verdict_.smallest_pivot;
        ++counts_.row_choices;
    } else if (verdict_.smallest_pivot < kRowsTurnBad * pivot_at_choice_) {
        choose_rows_again();
    }
    if (is_beginning_ && options_.project && equations_->rows_left_out() > 0) { take_up_rows(); }
    if (began_singular_) { pivot_at_choice_ = std::max(pivot_at_choice_, verdict_.smallest_pivot); }
    regular_pivot_ = std::max(regular_pivot_, verdict_.smallest_pivot);
}

/// Computes the rank again near the start. A scene that begins at a singular position leaves out rows that
/// become independent a step later or, from rest, when their residual exceeds rounding. Farther on, the rank
/// is not computed again: near a singular position, lengths that do not quite fit make rows look independent.
void ExplicitIntegrator::take_up_rows() {
    constexpr double far = 0.1;
    is_beginning_ = scales_.way(y_.data(), start_.data()) < far;
    if (counts_.steps > 1 && verdict_.left_out < left_out_asked_) { return; }
    left_out_asked_ = std::max(kAskedFrom, kAskedAgain * verdict_.left_out);
    if (!raise_rank(*equations_, t_, y_.data())) { return; }
    is_beginning_ = false;
    began_singular_ = true;
    ++counts_.row_choices;
    y_new_ = y_;
    tried_ = t_;
    project(t_, y_);
    // a motion that violates rows, and never satisfied them, was locked from the start: it is free to first
    // order only
    is_locked_ = scales_.difference(y_.data(), y_new_.data()) > kOneMotion;
    verdict_ = evaluate(t_, y_, stages_.front());
    pivot_at_choice_ = verdict_.smallest_pivot;
}

/// True if the end of the step violates the kept rows. False for NaN, which other checks report.
bool ExplicitIntegrator::is_off_constraints() const {
    const double drift = is_fixed() ? 0.0 : kDriftShare * options_.tolerance;
    return options_.project && verdict_new_.violation > std::max(kMet, drift);
}

bool ExplicitIntegrator::is_contradicted() const {
    return options_.project && verdict_.left_out > std::max(kContradicts, options_.tolerance);
}

/// Longest step in which every turn is counted correctly, at the rates and accelerations of its start [s].
double ExplicitIntegrator::longest_counted_step() {
    probed_.resize(at(equations_->bodies()));
    equations_->motion_of_bodies(t_, y_.data(), stages_.front().data(), probed_);
    double longest = std::numeric_limits<double>::infinity();
    for (const ProbedBody& body : probed_) {
        const double omega = body.omega.norm();
        // ω h + α h² / 2 = kCountedTurn
        const double root = std::sqrt(omega * omega + 2.0 * kCountedTurn * body.alpha.norm());
        if (root > 0.0) { longest = std::min(longest, 2.0 * kCountedTurn / (omega + root)); }
    }
    return longest;
}

/// Longest step allowed by rotations and harmonics [s].
double ExplicitIntegrator::longest_step() {
    if (equations_->counts_turns()) { return std::min(options_.longest_step, longest_counted_step()); }
    const double most = std::min(options_.most_turn, equations_->most_turn());
    if (!std::isfinite(most)) { return options_.longest_step; }
    const double omega = fastest_turn(*equations_, y_.data(), flat_);
    return omega > 0.0 ? std::min(options_.longest_step, most / omega) : options_.longest_step;
}

/// Chooses rows again, if others are better. If all are equally bad, the position itself is singular.
void ExplicitIntegrator::choose_rows_again() {
    const int left_out = equations_->rows_left_out();
    if (!equations_->choose_rows(t_, y_.data())) { return; }
    const RowsVerdict other = equations_->evaluate(t_, y_.data(), y_dot_new_.data());
    ++counts_.evaluations;
    if (equations_->rows_left_out() == left_out && other.smallest_pivot > 10.0 * verdict_.smallest_pivot) {
        ++counts_.row_choices;
        std::swap(stages_.front(), y_dot_new_);
        verdict_ = other;
        pivot_at_choice_ = other.smallest_pivot;
        return;
    }
    equations_->take_back_rows();
}

/// Growth of the step by a PI controller: if errors grow, the next one will be larger still, so using the
/// previous error reduces the number of rejected steps.
double ExplicitIntegrator::growth_after(double error) {
    const double most = rejected_before_ ? 1.0 : kMostGrowth;
    const double exponent = 1.0 / table_->order - 0.2 * kMemory;
    const double growth =
        error > 0.0 ? kSafety * elementary::pow(error, -exponent) * elementary::pow(last_error_, kMemory)
                    : most;
    last_error_ = std::max(error, 1e-4);
    return std::clamp(growth, 1.0 / 3.0, most);
}

bool ExplicitIntegrator::is_near_singular() const {
    // NaN fails every comparison
    return options_.project && !(lowest_pivot_ >= kNearSingular * regular_pivot_);
}

/// Takes the step with every stage on the constraints and restores the state of the integrator.
bool ExplicitIntegrator::reach(double t_from, const std::vector<double>& from, double t, double* y) {
    const double t_now = t_;
    const std::vector<double> y_now = y_;
    const std::vector<double> y_dot_now = stages_.front();
    const RowsVerdict verdict_now = verdict_;
    t_ = t_from;
    y_ = from;
    on_manifold_ = options_.project;
    verdict_ = evaluate(t_, y_, stages_.front());
    take_step(t - t_from);
    std::ranges::copy(y_new_, y);
    const bool met = verdict_new_.violation <= kMet && correction_ <= kOneMotion;
    t_ = t_now;
    y_ = y_now;
    stages_.front() = y_dot_now;
    verdict_ = verdict_now;
    return met;
}

/// True if the error is rounding: the previous attempt was longer, and its error hardly larger, whereas the
/// error of the method falls with its order.
bool ExplicitIntegrator::is_rounding(double error, double h) const {
    return h < rejected_.h && error > h / rejected_.h * (h / rejected_.h) * rejected_.error;
}

bool ExplicitIntegrator::step(double t_end) {
    if (is_contradicted() || is_locked_) { return false; }
    if (is_fixed()) { h_ = options_.fixed_step; }
    int dodges = 0;
    rejected_ = {};
    const double wanted = h_;
    for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
        const StepAhead ahead(t_, t_end, is_fixed() ? h_ : std::min(h_, longest_step()));
        const double h = ahead.h;
        on_manifold_ = false;
        take_step(h);
        const bool singular = is_near_singular();
        if (singular) {
            // off the constraints a small residual becomes a large acceleration there
            on_manifold_ = true;
            take_step(h);
            if (lowest_pivot_ < kTooNear * regular_pivot_ && dodges < kMostDodges) {
                // where no length helps, the whole motion is singular: then the original length is kept,
                // since shorter and shorter steps would never reach the end of the run
                h_ = ++dodges < kMostDodges ? kDodge * h : wanted;
                continue;
            }
        }
        tried_ = ahead.end;
        if (is_off_constraints()) {
            // out of reach: only a shorter step may help
            if (is_fixed() || h < kNoProgress * longest_taken_) { return false; }
            ++counts_.rejected;
            rejected_before_ = true;
            h_ = 0.3 * h;
            continue;
        }
        const double error = is_fixed() ? 0.0 : error_of(h);
        // the error estimate of a step through a singular position is rounding, not an error of the motion
        const bool small_enough =
            singular && h <= kSmallestShare * regular_step_ && is_rounding(error, h) &&
            error * options_.tolerance < most_error_through(lowest_pivot_ / regular_pivot_) &&
            correction_ <= most_correction_through(lowest_pivot_, options_.tolerance);
        if (std::isfinite(error) && (error <= 1.0 || small_enough)) {
            if (stiffness_.is_watching() && !is_fixed()) {
                stiffness_.take(h, stages_[stiffness_.stage()], y_new_, y_dot_new_, scales_);
            }
            accept(ahead.end);
            longest_taken_ = std::max(longest_taken_, h);
            if (singular) { ++counts_.singular_passages; }
            if (is_fixed()) { return true; }
            h_ = h * growth_after(error);
            rejected_before_ = false;
            if (!singular && !ahead.last) { regular_step_ = h; }
            if (singular) { h_ = std::max(h_, kSmallestShare * regular_step_); }
            return true;
        }
        ++counts_.rejected;
        rejected_before_ = true;
        rejected_ = {h, error};
        const double factor =
            std::isfinite(error) ? kSafety * elementary::pow(error, -1.0 / table_->order) : 0.1;
        h_ = h * std::clamp(factor, 0.1, 0.9);
    }
    return false;
}

}  // namespace jw
