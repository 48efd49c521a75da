#pragma once

#include <vector>

#include "core/integrate/runge_kutta.hpp"

/// Stiffness detection: whether stability, not accuracy, bounds the steps of an explicit method.
namespace jw {

class StateScales;

/// Stiffness test for an explicit method with an error estimate. A stage and the result both lie at the end
/// of a step: the difference of their derivatives divided by the difference of their states is a lower bound
/// of the largest |λ| of ∂f/∂y. Where h |λ| stays at the boundary of the stability region, accuracy does not
/// require short steps, and an implicit method takes longer ones.
/// @source Hairer, Wanner: Solving Ordinary Differential Equations II, section IV.2 (as in DOPRI5 and DOP853)
class StiffnessTest {
public:
    explicit StiffnessTest(const RungeKuttaTable& table);

    /// True if the state of this stage must be passed to `keep`.
    bool wants(std::size_t stage) const { return stage == stage_; }
    /// Stores the state of the stage that the result is compared with.
    void keep(const std::vector<double>& y) { y_stage_ = y; }
    /// Takes an accepted step of length `h` [s] into account.
    /// @param k_stage derivatives at the stage kept
    /// @param y state at the end
    /// @param y_dot derivatives there
    void take(
        double h, const std::vector<double>& k_stage, const std::vector<double>& y,
        const std::vector<double>& y_dot, const StateScales& scales);
    std::size_t stage() const { return stage_; }
    bool is_watching() const { return stage_ > 0; }

    /// Share of recent steps at the boundary of the stability region, 0 to 1; older steps fade.
    double share() const { return share_; }

private:
    std::size_t stage_ = 0;  ///< stage to compare with; 0: the method has none
    double edge_ = 0.0;      ///< h |λ| at the boundary of the stability region
    double share_ = 0.0;
    std::vector<double> y_stage_;
};

}  // namespace jw
