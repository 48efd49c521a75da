#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "core/motion/motion_equations.hpp"
#include "core/motion/tolerances.hpp"

/// Common interface of all integrators: one trajectory, one step at a time.
namespace jw {

/// Options of an integrator.
struct IntegrationOptions {
    /// Local error of a step, relative to the scales of the motion.
    double tolerance = kUsualTolerance;
    double fixed_step = 0.0;    ///< fixed step [s]; 0: steps follow the tolerance
    bool project = true;        ///< project onto the constraints whenever the drift nears the tolerance
    double length_scale = 1.0;  ///< extent of the scene [m]
    /// Largest rotation of a body within a step that follows the tolerance [rad].
    double most_turn = std::numeric_limits<double>::infinity();
    /// Longest step that follows the tolerance [s]: a driver may oscillate faster than the scene moves.
    double longest_step = std::numeric_limits<double>::infinity();
    /// Duration of the run [s]; a motion slower than one extent in this time counts as rest.
    double duration = 1e3;
};

/// Cost of an integration.
struct IntegrationCounts {
    long steps = 0;
    long rejected = 0;
    long evaluations = 0;        ///< evaluations of accelerations
    long projections = 0;        ///< projections onto the constraints
    long jacobians = 0;          ///< Jacobians of implicit methods
    long row_choices = 0;        ///< changes of the choice of rows
    long singular_passages = 0;  ///< steps near a singular position

    IntegrationCounts& operator+=(const IntegrationCounts& other);
};

/// Step of about `wanted` [s] from `t` that does not pass `t_end`. The remainder is divided into two equal
/// steps if it is shorter than 2 `wanted`, so that no step is tiny.
struct StepAhead {
    StepAhead(double t, double t_end, double wanted);

    double h;    ///< [s]
    double end;  ///< t + h, `t_end` itself for the last one
    bool last;
};

/// Scales of the error norm: the extent for lengths, 1 for p and angles, the fastest motion so far for
/// velocities.
class StateScales {
public:
    StateScales(const IntegrationOptions& options, std::vector<NumberScale> numbers);
    /// Includes the velocities of a state, and from rest those reached within `step` [s], in the scales.
    void include(const std::vector<double>& y, const std::vector<double>& y_dot, double step);
    /// Scale of the k-th number of y.
    double of(std::size_t k) const { return scale_[k]; }
    double omega() const { return omega_; }  ///< fastest rotation so far [rad/s]
    /// Largest difference between two states, each number divided by its scale.
    double difference(const double* y, const double* other) const;
    /// Largest difference between the poses of two states, each number divided by its scale.
    double way(const double* y, const double* other) const;
    /// Length of the first step [s]: a share of the time in which a number changes by its scale.
    double first_step(const std::vector<double>& y_dot, double tolerance, int order) const;

private:
    double largest(const std::vector<double>& y, NumberScale::Kind kind) const;
    double size_of(NumberScale::Kind kind) const;

    double length_;
    double slowest_;  ///< [1/s]
    std::vector<NumberScale> numbers_;
    std::vector<double> scale_;
    double velocity_ = 0.0;
    double omega_ = 0.0;
};

/// |ω| of the body that turns fastest at y [rad/s].
/// @param flat workspace for the flat state
double fastest_turn(const StateLayout& equations, const double* y, std::vector<double>& flat);

/// Integrator. After every step t, y and ẏ are those of one state, on the constraints if `project` is set.
class TimeStepper {
public:
    TimeStepper() = default;
    virtual ~TimeStepper() = default;
    TimeStepper(const TimeStepper&) = delete;
    TimeStepper& operator=(const TimeStepper&) = delete;

    /// Takes one step, not beyond `t_end`. @return false if the step became too small to continue
    virtual bool step(double t_end) = 0;

    virtual double t() const = 0;
    /// Time and state at the end of the last attempt, where `step` failed.
    virtual std::pair<double, std::vector<double>> tried() const { return {t(), y()}; }
    virtual const std::vector<double>& y() const = 0;
    virtual const std::vector<double>& y_dot() const = 0;
    virtual const IntegrationCounts& counts() const = 0;
    /// Share of recent steps whose length stability bounded, not accuracy: 0 to 1.
    virtual double bound_by_stability() const { return 0.0; }
    /// True if the method has dense output over the last step.
    virtual bool has_polynomial() const { return false; }
    /// Computes y within the last step from that polynomial, on the constraints. @return false if the result
    /// does not belong to this motion
    virtual bool interpolate(double /*t*/, double* /*y*/) { return false; }
    /// Computes y at `t` by one step from a state of this motion that is less than a step earlier; the
    /// integrator itself does not move. @return false if there is no such step
    virtual bool reach(double /*t_from*/, const std::vector<double>& /*from*/, double /*t*/, double* /*y*/) {
        return false;
    }
    /// Scales of the error norm; nullptr for a method without an error estimate.
    virtual const StateScales* scales() const { return nullptr; }
};

}  // namespace jw
