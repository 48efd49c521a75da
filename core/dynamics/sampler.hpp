#pragma once

#include <array>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "core/dynamics/time_stepper.hpp"

/// The state at asked times, between the steps of an integrator.
namespace jw {

/// Polynomials of degree 11 through four ends of steps: positions and their two derivatives are known there,
/// so that no evaluation is needed. The error, (step)¹², is below that of the methods. Methods with a
/// polynomial of their own (stiff ones, whose accelerations are less exact than their positions) give it
/// instead.
class Sampler {
public:
    using Receive = std::function<void(double t, const std::vector<double>& y)>;

    /// Calls `receive` once per time, in order, as soon as it is known; `times` ascend. What it gets is flat
    /// (flat_state.hpp) whatever the coordinates of `equations`, which must outlive this.
    Sampler(const MotionEquations& equations, std::vector<double> times, Receive receive)
        : equations_(&equations), times_(std::move(times)), receive_(std::move(receive)) {}

    /// To be called with the start and after every step.
    void take(const TimeStepper& stepper);
    /// What follows is no smooth continuation: no polynomial reaches across the end of the last step.
    void begin_anew();
    /// After the last step: what is left.
    void finish();

private:
    static constexpr std::size_t kNodes = 4;
    /// Values, rates and half the second derivatives side by side.
    struct Node {
        double t = 0.0;
        Eigen::ArrayX3d known;
    };

    void give_until(double t_end);
    void fit();
    void interpolate(double t);

    const MotionEquations* equations_;
    std::vector<double> times_;
    Receive receive_;
    std::size_t next_ = 0;
    std::array<Node, kNodes> nodes_;
    std::size_t known_ = 0;  ///< nodes that are set, the latest last
    // Newton's form of Hermite's polynomial: every node three times
    std::array<double, 3 * kNodes> x_{};
    Eigen::ArrayXXd coefficients_;
    Eigen::ArrayXXd differences_;
    Eigen::ArrayX2d value_and_rate_;
    bool fitted_ = false;    ///< to the nodes of now
    std::vector<double> y_;  ///< between steps, by a method's own polynomial
    std::vector<double> flat_;
};

}  // namespace jw
