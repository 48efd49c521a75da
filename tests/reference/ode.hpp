#pragma once

#include <functional>
#include <limits>

#include "tests/reference/scene.hpp"

/// Interface of equations of motion for an integrator, and two integrators.
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

/// Integrates from 0 to `duration` with a step ending at every sample's time. `tolerance`: of a step,
/// relative to 1 + |y|.
Trajectory integrate(Ode& ode, Real duration, Method method, Real tolerance);

using Receive = std::function<void(const VecX& y)>;

/// Integrates from the first of `times` to the last; a step ends at each of them and is passed to `receive`:
/// sampled moments, and those where a derivative jumps.
/// @throws std::runtime_error after `most_steps` or where no step is short enough
void integrate(
    Ode& ode, const std::vector<Real>& times, Method method, Real tolerance, const Receive& receive,
    long most_steps = std::numeric_limits<long>::max());

}  // namespace jw::reference
