#pragma once

#include <memory>
#include <vector>

#include "core/eigen/decompositions.hpp"
#include "core/equations/constraint_rounding.hpp"
#include "core/integrate/reduced_coordinates.hpp"

/// Radau IIA: implicit Runge-Kutta methods of s stages and order 2 s - 1, for stiff scenes.
namespace jw {

/// Coefficients of a method of s stages; vectors [s], matrices [s x s].
struct RadauTable {
    VectorX c;             ///< nodes, the last one 1
    MatrixX a;             ///< collocation matrix
    double gamma_0 = 0.0;  ///< real eigenvalue of a
    VectorX e;             ///< local error gamma_0 h f(y0) + Σ e_i z_i, of order s + 1
};
/// @param stages 3 for order 5 or 5 for order 9
RadauTable radau_table(int stages);

/// Radau integrator: collocation in reduced coordinates x. The unknowns are s times as many as these
/// coordinates, for any number of bodies.
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
    /// Evaluates the collocation polynomial in the reduced coordinates; all other numbers follow from the
    /// constraints.
    bool interpolate(double t, double* y) override;
    bool has_polynomial() const override { return last_step_ > 0.0; }
    const StateScales* scales() const override { return &scales_; }

private:
    /// Outcome of Newton's iteration for the stages.
    struct NewtonEnd {
        bool converged = false;
        int iterations = 0;
        double contraction = 1.0;
        double pivot_left = 1.0;                   ///< smallest over the stages
        double pivot_with_coordinates_left = 1.0;  ///< smallest over the stages
        double violation = 0.0;                    ///< largest over the stages
        bool is_near_singular() const;
        bool is_too_near() const;  ///< too near for accelerations, or coordinates, to have digits
    };
    /// Attempts at one step.
    struct Trial {
        bool doubtful = false;       ///< whether the first error estimate is not reliable
        bool renewed = false;        ///< whether the Jacobian is that of this step
        bool without_slope = false;  ///< whether the Jacobian is replaced by zero
        int dodges = 0;
        double most_growth = 1.0;  ///< bound on the growth of the next step
    };

    void evaluate(double t, const VectorX& x, double* y, double* y_dot, Eigen::Ref<VectorX> x_dot);
    Eigen::Map<const VectorX> start_numbers() const {
        return {y_.data(), static_cast<Eigen::Index>(y_.size())};
    }
    void choose_coordinates();
    bool keeps_its_place();
    bool jacobian_is_stale() const;
    void renew_jacobian();
    void factor(double h);
    void predict(double h);
    NewtonEnd solve_stages(double h);
    double rounding_through(double h, double pivot) const;
    double error_of(double h, bool doubtful);
    void accept(double h, double t);
    /// Rotations of the step solved last: the fastest rotation of a body in its stages [rad/s], and the
    /// largest from the start to a stage [rad].
    struct Turning {
        double rate = 0.0;
        double angle = 0.0;
    };
    Turning turning_of_stages() const;
    bool turned_too_far(double h);
    /// True if the stages follow from the start by the rates of all bodies, not only by those of the few
    /// coordinates.
    bool is_one_motion(double h) const;
    bool try_otherwise(double h, const NewtonEnd& newton, Trial& trial);
    double growth_after(double error, int iterations) const;
    double most_turn() const;
    /// Norm of a change of x, relative to the tolerance.
    double norm(const VectorX& change) const;
    /// Weights of the start and the stages of the last step at relative time `tau`, 0 to 1 within the step.
    VectorX weights(double tau) const;

    MotionEquations* equations_;
    RadauTable table_;
    IntegrationOptions options_;
    IntegrationCounts counts_;
    StateScales scales_;
    double t_;
    double h_ = 0.0;      ///< step to try next [s]
    double tried_ = 0.0;  ///< end of the last attempt [s]
    double left_out_asked_ = kAskedFrom;
    bool choose_again_ = false;  ///< whether other coordinates must be chosen
    double regular_step_ = 0.0;  ///< last step away from singular positions [s]
    std::vector<double> y_;
    std::vector<double> y_dot_;
    std::unique_ptr<ReducedCoordinates> coordinates_;
    VectorX x_;
    VectorX x_dot_;
    VectorX x_scale_;
    MatrixX reduced_;  ///< ∂ẋ/∂x, 2 d x 2 d
    Eigen::PartialPivLU<MatrixX> stages_lu_;
    Eigen::PartialPivLU<MatrixX> error_lu_;
    double factored_step_ = 0.0;  ///< h of the two factorisations [s]
    double most_growth_ = 6.0;    ///< bound on the growth of the next step
    double contraction_ = 0.0;    ///< contraction of Newton's iteration in the last step
    MatrixX x_stages_;            ///< x of the stages, one column each
    MatrixX x_rates_;
    MatrixX y_stages_;  ///< y of the stages
    MatrixX y_rates_;   ///< ẏ of the stages
    std::vector<double> flat_;
    MatrixX x_before_;          ///< x at the start and at the stages of the last accepted step
    MatrixX y_before_;          ///< y there
    double step_before_ = 0.0;  ///< h of the last step [s]; 0 if there was none in these coordinates
    double last_step_ = 0.0;    ///< h of the last step in any coordinates [s]
};

}  // namespace jw
