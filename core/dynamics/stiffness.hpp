#pragma once

#include <vector>

#include "core/dynamics/runge_kutta.hpp"

/// Whether stability, not accuracy, decides how long the steps of an explicit method are.
namespace jw {

class StateScales;

/// Watches the steps of an explicit method with an error estimate. A stage and the result both lie at the end
/// of a step, a little apart: the difference of their derivatives by that of their states is a lower bound of
/// the largest |λ| of ∂f/∂y. Where h |λ| stays at the edge of what the method is stable for, shorter steps
/// are not what accuracy asks for, and an implicit method takes longer ones.
/// @source Hairer, Wanner: Solving Ordinary Differential Equations II, section IV.2 (as in DOPRI5 and DOP853)
class StiffnessTest {
public:
    explicit StiffnessTest(const RungeKuttaTable& table);

    /// Whether the state of this stage is to be shown to `keep`.
    bool wants(std::size_t stage) const { return stage == stage_; }
    void keep(const std::vector<double>& y) { y_stage_ = y; }
    /// An accepted step of length `h` [s]. @param k_stage, y_dot derivatives at the stage kept and at the end
    /// `y`
    void take(
        double h, const std::vector<double>& k_stage, const std::vector<double>& y,
        const std::vector<double>& y_dot, const StateScales& scales);
    std::size_t stage() const { return stage_; }
    bool is_watching() const { return stage_ > 0; }

    /// Of the steps taken lately: the share of those at the edge of stability, 0 to 1, older ones fading.
    double share() const { return share_; }

private:
    std::size_t stage_ = 0;  ///< 0: the method has none to compare with
    double edge_ = 0.0;      ///< h |λ| at which the method is about to become unstable
    double share_ = 0.0;
    std::vector<double> y_stage_;
};

}  // namespace jw
