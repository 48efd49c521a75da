#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "core/dynamics/motion_equations.hpp"

/// What all integrators have in common: one trajectory, a step at a time.
namespace jw {

struct IntegrationOptions {
    double tolerance = 1e-6;    ///< local error of a step, relative to the scales of the motion
    double fixed_step = 0.0;    ///< [s]; 0: steps follow the tolerance
    bool project = true;        ///< back onto the constraints whenever the drift nears the tolerance
    double length_scale = 1.0;  ///< [m]
    /// Of a body, within a step that follows the tolerance [rad].
    double most_turn = std::numeric_limits<double>::infinity();
    /// Of a step that follows the tolerance [s]: what drives the scene may swing faster than it moves.
    double longest_step = std::numeric_limits<double>::infinity();
    /// What moves more slowly than by its size in this time counts as being at rest [s].
    double duration = 1e3;
};

struct IntegrationCounts {
    long steps = 0;
    long rejected = 0;
    long evaluations = 0;        ///< of accelerations
    long projections = 0;        ///< onto the constraints
    long jacobians = 0;          ///< of implicit methods
    long row_choices = 0;        ///< how often other rows were kept from then on
    long singular_passages = 0;  ///< steps near a singular position
};

/// A step of about `wanted` [s] from `t` on that does not pass `t_end`. Of what is left the last two steps
/// are taken in halves, so that none is tiny.
struct StepAhead {
    StepAhead(double t, double t_end, double wanted);

    double h;    ///< [s]
    double end;  ///< t + h, `t_end` itself for the last one
    bool last;
};

/// Sizes that errors are compared with: lengths of the scene, 1 for p, the fastest motion so far.
class StateScales {
public:
    StateScales(const IntegrationOptions& options, std::vector<NumberScale> numbers);
    void include(const std::vector<double>& y, const std::vector<double>& y_dot, double step);
    /// Of the k-th number of y.
    double of(std::size_t k) const { return scale_[k]; }
    double omega() const { return omega_; }  ///< of the fastest turning [rad/s]
    /// Largest of the differences between two states, each by its size.
    double difference(const double* y, const double* other) const;
    /// Largest difference of the poses of two states, each number by its size.
    double way(const double* y, const double* other) const;
    /// A share of the time in which something moves by its size [s].
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

/// |ω| of the body that turns fastest at y [rad/s]. @param flat room for the state
double fastest_turn(const MotionEquations& equations, const double* y, std::vector<double>& flat);

/// After every step t, y and ẏ are those of a state on the constraints.
class TimeStepper {
public:
    TimeStepper() = default;
    virtual ~TimeStepper() = default;
    TimeStepper(const TimeStepper&) = delete;
    TimeStepper& operator=(const TimeStepper&) = delete;

    /// One step, not beyond `t_end`. @return false if the step became too small to go on
    virtual bool step(double t_end) = 0;

    virtual double t() const = 0;
    /// Time and state at the end of the last attempt, where `step` failed.
    virtual std::pair<double, std::vector<double>> tried() const { return {t(), y()}; }
    virtual const std::vector<double>& y() const = 0;
    virtual const std::vector<double>& y_dot() const = 0;
    virtual const IntegrationCounts& counts() const = 0;
    /// Of the steps taken lately, the share of those that stability kept short, not accuracy: 0 to 1.
    virtual double bound_by_stability() const { return 0.0; }
    /// Whether the method has a polynomial of its own over the last step.
    virtual bool has_polynomial() const { return false; }
    /// y within the last step by that, on the constraints. @return false if it is not to be had: what was
    /// found is no part of this motion
    virtual bool interpolate(double /*t*/, double* /*y*/) { return false; }
    /// y at `t`, by one step from an earlier state of this motion less than a step before; the motion itself
    /// stays where it is. @return false if there is no such step
    virtual bool reach(double /*t_from*/, const std::vector<double>& /*from*/, double /*t*/, double* /*y*/) {
        return false;
    }
    /// What errors are compared with; nothing where a method compares none.
    virtual const StateScales* scales() const { return nullptr; }
};

}  // namespace jw
