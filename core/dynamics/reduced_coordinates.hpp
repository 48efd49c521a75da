#pragma once

#include "core/dynamics/motion_equations.hpp"
#include "core/dynamics/time_stepper.hpp"

/// What implicit methods integrate: ẋ = f(t, x) with few numbers that no constraint binds.
namespace jw {

class ReducedCoordinates {
public:
    ReducedCoordinates() = default;
    virtual ~ReducedCoordinates() = default;
    ReducedCoordinates(const ReducedCoordinates&) = delete;
    ReducedCoordinates& operator=(const ReducedCoordinates&) = delete;

    /// Chooses what x is at y. @return x there
    virtual VectorX choose(double t, const double* y) = 0;
    /// Whether the choice is still good where it was evaluated last.
    virtual bool is_sound() const = 0;
    /// Smallest pivot of the rows where it was evaluated last, by the best that any choice began with: falls
    /// as (distance)² to a singular position.
    virtual double pivot_left() const { return 1.0; }
    /// The same of rows and coordinates together, by what this choice began with: falls also where the
    /// coordinates stop telling the freedoms apart.
    virtual double pivot_with_coordinates_left() const { return 1.0; }
    /// Moves y, an estimate, to where the coordinates are x, and tells ẏ and ẋ.
    virtual void evaluate(
        double t, const VectorX& x, double* y, double* y_dot, Eigen::Ref<VectorX> x_dot) = 0;
    /// The motion has come to y: whole turns are counted on from there.
    virtual void follow_turns(double /*t*/, const double* /*y*/) {}
    /// Whether that takes a projection.
    virtual bool are_projected() const { return true; }
    /// Of the equations there.
    virtual RowsVerdict verdict() const { return {}; }
    /// Sizes that changes of x are compared with.
    virtual VectorX sizes(const StateScales& scales) const = 0;
};

/// Equations without rows: x is y itself. They must outlive this.
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
