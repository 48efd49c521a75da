#pragma once

#include <vector>

#include "core/dynamics/constraint_rounding.hpp"
#include "core/dynamics/runge_kutta.hpp"
#include "core/dynamics/stiffness.hpp"
#include "core/dynamics/time_stepper.hpp"

/// Explicit Runge-Kutta methods with steps that follow the error, made for constraints.
namespace jw {

/// Keeps one set of rows over a step and chooses anew when it turns bad. A step near a singular position is
/// repeated with every stage moved onto the constraints first, where small residuals do no harm.
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
    bool is_off_constraints() const;  ///< at the end of the step, projected or not
    bool is_contradicted() const;     ///< by rows left out, at its start
    double longest_step();
    bool is_fixed() const { return options_.fixed_step > 0.0; }
    void project(double t, std::vector<double>& y);
    RowsVerdict evaluate(double t, std::vector<double>& y, std::vector<double>& y_dot);
    RowsVerdict evaluate_end(double t);
    void correct_end(double t);

    MotionEquations* equations_;
    const RungeKuttaTable* table_;
    IntegrationOptions options_;
    IntegrationCounts counts_;
    StateScales scales_;
    StiffnessTest stiffness_;
    double t_;
    double h_ = 0.0;             ///< to try next [s]
    double regular_step_ = 0.0;  ///< last one away from singular positions [s]
    bool rejected_before_ = false;
    /// Attempt at this step that was refused last; none: no length.
    struct Attempt {
        double h = 0.0;
        double error = 0.0;  ///< by the tolerance
    };
    Attempt rejected_;
    double last_error_ = 1e-4;  ///< of the last step taken, by the tolerance
    std::vector<double> y_;
    std::vector<double> y_new_;
    std::vector<double> y_dot_new_;
    std::vector<std::vector<double>> stages_;
    std::vector<double> flat_;
    RowsVerdict verdict_;      ///< at the start of the step
    RowsVerdict verdict_new_;  ///< at its end
    RowsVerdict verdict_of_last_stage_;
    double pivot_at_choice_ = 1.0;
    double regular_pivot_ = 1.0;  ///< largest so far: rows may have been chosen beside a singular position
    std::vector<double> start_;
    bool is_beginning_ = true;
    bool began_singular_ = false;
    bool is_locked_ = false;  ///< by rows that were left out at the start
    double left_out_asked_ = kAskedFrom;
    double tried_ = 0.0;          ///< end of the last attempt [s]
    double longest_taken_ = 0.0;  ///< longest step so far [s]
    double lowest_pivot_ = 1.0;   ///< over the stages of the last step
    double correction_ = 0.0;     ///< of the end of a step on the manifold, by the scales of the motion
    bool on_manifold_ = false;    ///< stages are projected before they are evaluated
};

}  // namespace jw
