#pragma once

#include <functional>
#include <limits>

#include "tests/reference/scene.hpp"

/// What an integrator needs of equations of motion, and two integrators.
namespace jw::reference {

/// y' = f(y) with a manifold that y stays on.
class Ode {
public:
    virtual ~Ode() = default;
    virtual VecX start() const = 0;
    /// Chooses what stays fixed over one step: which of redundant rows are kept.
    virtual void begin_step(const VecX& y) = 0;
    virtual void derivative(const VecX& y, VecX& y_dot) = 0;
    /// Back onto the manifold.
    virtual void project(VecX& y) = 0;
    virtual Sample sample(const VecX& y) = 0;
};

enum class Method {
    runge_kutta_fehlberg,  ///< 7(8)
    extrapolation,         ///< of the modified midpoint rule (Gragg, Bulirsch, Stoer), order 14
};

/// From 0 to `duration`, stepping on every sample's time. `tolerance`: of a step, against 1 + |y|.
Trajectory integrate(Ode& ode, Real duration, Method method, Real tolerance);

using Receive = std::function<void(const VecX& y)>;

/// The same from the first of `times` to the last, every one of them the end of a step that `receive` is
/// given: sampled moments, and those where a derivative jumps.
/// @throws std::runtime_error after `most_steps` or where no step is short enough
void integrate(
    Ode& ode, const std::vector<Real>& times, Method method, Real tolerance, const Receive& receive,
    long most_steps = std::numeric_limits<long>::max());

}  // namespace jw::reference
