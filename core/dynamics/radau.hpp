#pragma once

#include <memory>
#include <vector>

#include <Eigen/LU>

#include "core/dynamics/constraint_rounding.hpp"
#include "core/dynamics/reduced_coordinates.hpp"

/// Radau IIA: implicit Runge-Kutta methods of order 2 s - 1 for stiff scenes.
namespace jw {

/// A method of s stages; sizes s and s x s.
struct RadauTable {
    VectorX c;             ///< nodes, the last one 1
    MatrixX a;             ///< collocation
    double gamma_0 = 0.0;  ///< real eigenvalue of a
    VectorX e;             ///< local error gamma_0 h f(y0) + Σ e_i z_i, of order s + 1
};
/// @param stages odd: 3 for order 5, 5 for order 9
RadauTable radau_table(int stages);

/// Collocation in reduced coordinates x: s times as many unknowns as these, whatever the number of bodies.
class RadauIntegrator final : public TimeStepper {
public:
    /// `equations` must outlive this; `y` is projected first.
    RadauIntegrator(
        MotionEquations& equations, std::unique_ptr<ReducedCoordinates> coordinates, int stages,
        const IntegrationOptions& options, double t, std::vector<double> y);

    bool step(double t_end) override;
    double t() const override { return t_; }
    const std::vector<double>& y() const override { return y_; }
    const std::vector<double>& y_dot() const override { return y_dot_; }
    const IntegrationCounts& counts() const override { return counts_; }
    std::pair<double, std::vector<double>> tried() const override {
        const auto end = y_stages_.rightCols(1);
        return {tried_, {end.data(), end.data() + end.size()}};
    }
    /// The polynomial of the step in its coordinates; all others follow from the constraints.
    bool interpolate(double t, double* y) override;
    bool has_polynomial() const override { return last_step_ > 0.0; }
    const StateScales* scales() const override { return &scales_; }

private:
    /// How Newton's iteration for the stages ended.
    struct NewtonEnd {
        bool converged = false;
        int iterations = 0;
        double contraction = 1.0;
        double pivot_left = 1.0;                   ///< least of the stages
        double pivot_with_coordinates_left = 1.0;  ///< likewise
        double violation = 0.0;                    ///< largest of the stages
        bool is_near_singular() const;
        bool is_too_near() const;  ///< for accelerations, or coordinates, to have digits
    };
    /// What has been tried for one step.
    struct Trial {
        bool doubtful = false;       ///< the first estimate of its error is not to be trusted
        bool renewed = false;        ///< the Jacobian is of this step
        bool without_slope = false;  ///< the Jacobian is zero
        int dodges = 0;
        double most_growth = 1.0;  ///< of the next step
    };

    void evaluate(double t, const VectorX& x, double* y, double* y_dot, Eigen::Ref<VectorX> x_dot);
    Eigen::Map<const VectorX> start_numbers() const {
        return {y_.data(), static_cast<Eigen::Index>(y_.size())};
    }
    void choose_coordinates();
    bool jacobian_is_stale() const;
    void renew_jacobian();
    void factor(double h);
    void predict(double h);
    NewtonEnd solve_stages(double h);
    double rounding_through(double h, double pivot) const;
    double error_of(double h, bool doubtful);
    void accept(double h, double t);
    /// The step that was solved last: the fastest turn of a body in its stages [rad/s], and the largest from
    /// its start to one of them [rad].
    struct Turning {
        double rate = 0.0;
        double angle = 0.0;
    };
    Turning turning_of_stages() const;
    bool turned_too_far(double h);
    /// Whether the stages follow from the start by the rates of all bodies, not of the few coordinates only.
    bool is_one_motion(double h) const;
    bool try_otherwise(double h, const NewtonEnd& newton, Trial& trial);
    double growth_after(double error, int iterations) const;
    double most_turn() const;
    /// Size of a change of x, by the tolerance.
    double norm(const VectorX& change) const;
    /// Of the start and the stages of the last step in a point `tau` of it, by their polynomial.
    VectorX weights(double tau) const;

    MotionEquations* equations_;
    RadauTable table_;
    IntegrationOptions options_;
    IntegrationCounts counts_;
    StateScales scales_;
    double t_;
    double h_ = 0.0;      ///< to try next [s]
    double tried_ = 0.0;  ///< end of the last attempt [s]
    double left_out_asked_ = kAskedFrom;
    bool choose_again_ = false;  ///< other coordinates are due
    double regular_step_ = 0.0;  ///< last one away from singular positions [s]
    std::vector<double> y_;
    std::vector<double> y_dot_;
    std::unique_ptr<ReducedCoordinates> coordinates_;
    VectorX x_;
    VectorX x_dot_;
    VectorX x_scale_;
    MatrixX reduced_;  ///< ∂ẋ/∂x, 2 d x 2 d
    Eigen::PartialPivLU<MatrixX> stages_lu_;
    Eigen::PartialPivLU<MatrixX> error_lu_;
    double factored_step_ = 0.0;  ///< h of the two [s]
    double most_growth_ = 6.0;    ///< of the next step
    double contraction_ = 0.0;    ///< of Newton's iteration in the last step
    MatrixX x_stages_;            ///< of the stages, one column each
    MatrixX x_rates_;
    MatrixX y_stages_;  ///< the whole mechanism there
    MatrixX y_rates_;   ///< and how fast it moves there
    std::vector<double> flat_;
    MatrixX x_before_;          ///< x at the start and at the stages of the last accepted step
    MatrixX y_before_;          ///< y there
    double step_before_ = 0.0;  ///< its h [s]; 0: there was none in these coordinates
    double last_step_ = 0.0;    ///< its h in any coordinates [s]
};

}  // namespace jw
