#pragma once

#include <vector>

#include "core/integrate/simulation.hpp"
#include "core/integrate/time_stepper.hpp"
#include "lessons/lesson/lesson.hpp"

namespace jw::peers {

/// Ways to keep an integrator that knows no constraints on the constraints of loops.
enum class Held {
    /// Projection after a step that has drifted by a tenth of the tolerance, as our explicit methods do.
    after_steps,
    /// ẏ = f(t, P y) - κ (y - P y) with P the projection onto the constraints: the same motion on them, and a
    /// state off them returns. For integrators whose steps must not be moved from outside.
    within,
    /// Projection of samples only: the motion drifts.
    in_samples,
};

/// The equations of motion that our explicit methods integrate, in the coordinates that are chosen for them,
/// for other integrators: every evaluation is counted.
class CountedEquations {
public:
    CountedEquations(const Lesson& lesson, double tolerance, Held held);

    int size() const { return equations().size(); }
    MotionEquations& equations() const { return simulation_.integrated(); }
    const Simulation& simulation() const { return simulation_; }
    const std::vector<double>& start() const { return start_; }
    double tolerance() const { return tolerance_; }
    const StateScales& scales() const { return scales_; }
    /// First step: a fraction of the time in which something moves by its size [s].
    double first_step(int order) const;
    bool has_loops() const { return equations().rows() > 0; }

    /// ẏ. The last state is not evaluated twice. @return false if it is not finite
    bool evaluate(double t, const double* y, double* y_dot);
    /// Moves y back where it has drifted. @return whether it had
    bool project_drifted(double t, double* y);
    void project(double t, double* y);
    /// Updates scales, turns and rows after the motion has reached y.
    void follow(double t, const std::vector<double>& y);

    long evaluations() const { return evaluations_; }
    long projections() const { return projections_; }

private:
    void evaluate_anew();
    RowsVerdict evaluate_counted(double t, const double* y, double* y_dot);
    void evaluate_on_constraints(double t, const double* y, double* y_dot);
    void choose_rows_again(double t, const double* y);

    Simulation simulation_;
    double tolerance_;
    Held held_;
    std::vector<double> start_;
    StateScales scales_;
    std::vector<double> first_rates_;
    std::vector<double> moved_;  ///< the last y, projected onto the constraints
    std::vector<double> last_y_;
    std::vector<double> last_rates_;
    double last_t_ = 0.0;
    double pivot_at_choice_ = 1.0;
    double regular_pivot_ = 1.0;  ///< largest so far
    long evaluations_ = 0;
    long projections_ = 0;
};

}  // namespace jw::peers
