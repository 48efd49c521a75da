#pragma once

#include <vector>

#include "core/dynamics/motion_equations.hpp"
#include "core/dynamics/runge_kutta.hpp"

/// Steps the equations of motion forward in time.
namespace jw {

struct IntegrationOptions {
    const RungeKuttaTable* table = nullptr;
    double tolerance = 1e-6;    ///< local error of a step, relative to the scales of the motion
    double fixed_step = 0.0;    ///< [s]; 0: steps follow the tolerance
    bool project = true;        ///< back onto the constraints whenever the drift nears the tolerance
    double length_scale = 1.0;  ///< [m]
};

struct IntegrationCounts {
    long steps = 0;
    long rejected = 0;
    long evaluations = 0;
    long projections = 0;
    long row_choices = 0;        ///< how often other rows were kept from then on
    long singular_passages = 0;  ///< steps near a singular position
};

/// One trajectory. After every step t, y and ẏ are those of a state on the constraints.
class Integrator {
public:
    /// `equations` must outlive this; `y` is projected first.
    Integrator(
        MotionEquations& equations, const IntegrationOptions& options, double t, std::vector<double> y);

    /// One step, not beyond `t_end`. @return false if the step became too small to go on
    bool step(double t_end);

    double t() const { return t_; }
    const std::vector<double>& y() const { return y_; }
    const std::vector<double>& y_dot() const { return stages_.front(); }
    const IntegrationCounts& counts() const { return counts_; }
    double smallest_pivot() const { return verdict_.smallest_pivot; }

private:
    void take_step(double h);
    void accept(double t);
    bool is_near_singular() const;
    double error_of(double h) const;
    double first_step() const;
    void update_scales();
    RowsVerdict evaluate(double t, std::vector<double>& y, std::vector<double>& y_dot);
    RowsVerdict evaluate_end(double t);

    MotionEquations* equations_;
    IntegrationOptions options_;
    IntegrationCounts counts_;
    double t_;
    double h_ = 0.0;             ///< to try next [s]
    double regular_step_ = 0.0;  ///< last one away from singular positions [s]
    bool rejected_before_ = false;
    std::vector<double> y_;
    std::vector<double> y_new_;
    std::vector<double> y_dot_new_;
    std::vector<std::vector<double>> stages_;
    RowsVerdict verdict_;      ///< at the start of the step
    RowsVerdict verdict_new_;  ///< at its end
    double pivot_at_choice_ = 1.0;
    double lowest_pivot_ = 1.0;  ///< over the stages of the last step
    bool on_manifold_ = false;   ///< stages are projected before they are evaluated
    double velocity_scale_ = 0.0;
    double omega_scale_ = 0.0;
};

}  // namespace jw
