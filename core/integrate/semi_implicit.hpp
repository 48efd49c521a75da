#pragma once

#include "core/integrate/time_stepper.hpp"

namespace jw {

/// Semi-implicit (symplectic) Euler, for teaching: velocities first, positions with the new velocities. Order
/// 1, but its energy stays near the true one where that of explicit Euler grows.
class SemiImplicitEuler final : public TimeStepper {
public:
    /// `equations` must outlive this. @param options fixed_step > 0
    SemiImplicitEuler(
        MotionEquations& equations, const IntegrationOptions& options, double t, std::vector<double> y);

    bool step(double t_end) override;
    double t() const override { return t_; }
    const std::vector<double>& y() const override { return y_; }
    const std::vector<double>& y_dot() const override { return y_dot_; }
    const IntegrationCounts& counts() const override { return counts_; }
    std::pair<double, std::vector<double>> tried() const override { return {tried_, y_new_}; }

private:
    MotionEquations* equations_;
    IntegrationOptions options_;
    IntegrationCounts counts_;
    double t_;
    double tried_ = 0.0;  ///< end of the last step, taken or not [s]
    std::vector<double> y_;
    std::vector<double> y_new_;
    std::vector<double> y_dot_;
    RowsVerdict verdict_;
};

}  // namespace jw
