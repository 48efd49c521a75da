#pragma once

#include <vector>

#include "core/equations/constraint_rounding.hpp"
#include "core/integrate/runge_kutta.hpp"
#include "core/integrate/stiffness.hpp"
#include "core/integrate/time_stepper.hpp"

/// Explicit Runge-Kutta methods with step-size control, for constrained motion.
namespace jw {

/// Integrator that keeps one choice of rows over a step and chooses again when its pivots turn bad. A step
/// near a singular position is repeated with every stage projected onto the constraints first, where small
/// residuals do no harm.
class ExplicitIntegrator final : public TimeStepper {
public:
    /// `equations` must outlive this; `y` is projected first.
    ExplicitIntegrator(
        MotionEquations& equations, const RungeKuttaTable& table, const IntegrationOptions& options, double t,
        std::vector<double> y);

    bool step(double t_end) override;
    double t() const override { return t_; }
    const std::vector<double>& y() const override { return y_; }
    const std::vector<double>& y_dot() const override { return stages_.front(); }
    const IntegrationCounts& counts() const override { return counts_; }
    double bound_by_stability() const override { return stiffness_.share(); }
    std::pair<double, std::vector<double>> tried() const override { return {tried_, y_new_}; }
    bool reach(double t_from, const std::vector<double>& from, double t, double* y) override;
    const StateScales* scales() const override { return &scales_; }

private:
    void take_step(double h);
    void accept(double t);
    bool is_near_singular() const;
    bool is_rounding(double error, double h) const;
    double growth_after(double error);
    double error_of(double h) const;
    void choose_rows_again();
    void take_up_rows();
    bool is_off_constraints() const;  ///< whether the end of the step violates the kept rows
    bool is_contradicted() const;     ///< whether rows left out are violated at the start of the step
    double longest_step();
    double longest_counted_step();
    bool is_fixed() const { return options_.fixed_step > 0.0; }
    void project(double t, std::vector<double>& y);
    RowsVerdict evaluate(double t, std::vector<double>& y, std::vector<double>& y_dot);
    RowsVerdict evaluate_end(double t);
    void correct_end(double t);

    MotionEquations* equations_;
    std::vector<ProbedBody> probed_;
    const RungeKuttaTable* table_;
    IntegrationOptions options_;
    IntegrationCounts counts_;
    StateScales scales_;
    StiffnessTest stiffness_;
    double t_;
    double h_ = 0.0;             ///< step to try next [s]
    double regular_step_ = 0.0;  ///< last step away from singular positions [s]
    bool rejected_before_ = false;
    /// Last rejected attempt at this step; h = 0 if there is none.
    struct Attempt {
        double h = 0.0;
        double error = 0.0;  ///< relative to the tolerance
    };
    Attempt rejected_;
    double last_error_ = 1e-4;  ///< error of the last accepted step, relative to the tolerance
    std::vector<double> y_;
    std::vector<double> y_new_;
    std::vector<double> y_dot_new_;
    std::vector<std::vector<double>> stages_;
    std::vector<double> flat_;
    RowsVerdict verdict_;      ///< verdict at the start of the step
    RowsVerdict verdict_new_;  ///< verdict at its end
    RowsVerdict verdict_of_last_stage_;
    double pivot_at_choice_ = 1.0;
    double regular_pivot_ = 1.0;  ///< largest so far: a choice may have been made near a singular position
    std::vector<double> start_;
    bool is_beginning_ = true;
    bool began_singular_ = false;
    bool is_locked_ = false;  ///< whether rows left out at the start lock the motion
    double left_out_asked_ = kAskedFrom;
    double tried_ = 0.0;          ///< end of the last attempt [s]
    double longest_taken_ = 0.0;  ///< longest step so far [s]
    double lowest_pivot_ = 1.0;   ///< lowest pivot over the stages of the last step
    double correction_ = 0.0;     ///< projection of the end of a singular step, in scales of the motion
    bool on_manifold_ = false;    ///< stages are projected before they are evaluated
};

}  // namespace jw
