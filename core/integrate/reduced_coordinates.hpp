#pragma once

#include "core/integrate/time_stepper.hpp"
#include "core/motion/motion_equations.hpp"

/// Coordinates of implicit methods: ẋ = f(t, x) with few numbers that no constraint couples.
namespace jw {

/// Interface of the coordinates x that implicit methods integrate.
class ReducedCoordinates {
public:
    ReducedCoordinates() = default;
    virtual ~ReducedCoordinates() = default;
    ReducedCoordinates(const ReducedCoordinates&) = delete;
    ReducedCoordinates& operator=(const ReducedCoordinates&) = delete;

    /// Chooses coordinates at y. @return x there
    virtual VectorX choose(double t, const double* y) = 0;
    /// True if the choice is still valid at the last evaluation.
    virtual bool is_sound() const = 0;
    /// Smallest pivot of the rows at the last evaluation, relative to the best at any choice: falls as
    /// (distance)² towards a singular position.
    virtual double pivot_left() const { return 1.0; }
    /// Smallest pivot of rows and coordinates together, relative to their pivots at this choice: falls also
    /// where the coordinates stop distinguishing the freedoms.
    virtual double pivot_with_coordinates_left() const { return 1.0; }
    /// Moves y, an estimate, to the state with coordinates x, and computes ẏ and ẋ.
    virtual void evaluate(
        double t, const VectorX& x, double* y, double* y_dot, Eigen::Ref<VectorX> x_dot) = 0;
    /// Continues the count of whole turns at y, the next state of the motion.
    virtual void follow_turns(double /*t*/, const double* /*y*/) {}
    /// True if `evaluate` projects y.
    virtual bool are_projected() const { return true; }
    /// Verdict of the equations at the last evaluation.
    virtual RowsVerdict verdict() const { return {}; }
    /// Scales for changes of x.
    virtual VectorX sizes(const StateScales& scales) const = 0;
};

/// Coordinates of equations without rows: x is y itself. The equations must outlive this.
class FreeCoordinates final : public ReducedCoordinates {
public:
    explicit FreeCoordinates(MotionEquations& equations) : equations_(&equations) {}

    VectorX choose(double /*t*/, const double* y) override {
        return Eigen::Map<const VectorX>(y, equations_->size());
    }
    bool is_sound() const override { return true; }
    bool are_projected() const override { return false; }
    void evaluate(double t, const VectorX& x, double* y, double* y_dot, Eigen::Ref<VectorX> x_dot) override {
        std::copy_n(x.data(), x.size(), y);
        equations_->evaluate(t, y, y_dot);
        x_dot = Eigen::Map<const VectorX>(y_dot, x.size());
    }
    VectorX sizes(const StateScales& scales) const override {
        VectorX out(equations_->size());
        for (Eigen::Index k = 0; k < out.size(); ++k) { out(k) = scales.of(static_cast<std::size_t>(k)); }
        return out;
    }

private:
    MotionEquations* equations_;
};

}  // namespace jw
