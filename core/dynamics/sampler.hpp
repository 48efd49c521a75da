#pragma once

#include <array>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "core/dynamics/hermite.hpp"
#include "core/dynamics/time_stepper.hpp"

/// The state at asked times, between the steps of an integrator.
namespace jw {

/// Polynomials of degree 11 through four ends of steps: positions and their two derivatives are known there,
/// so that no evaluation is needed. The error, (step)¹², is below that of the methods. Where steps had to
/// become short at once, and what is far off bends the polynomial, it goes through the two ends beside only.
/// Methods with a polynomial of their own (stiff ones, whose accelerations are less exact than their
/// positions) give it instead.
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
    using Node = HermitePolynomial::Node;
    static constexpr std::size_t kNodes = HermitePolynomial::kMostNodes;

    void give_until(double t_end);
    void interpolate(double t);
    HermitePolynomial& polynomial_at(double t);
    HermitePolynomial& polynomial_between(const Node* ends);

    const MotionEquations* equations_;
    std::vector<double> times_;
    Receive receive_;
    std::size_t next_ = 0;
    std::array<Node, kNodes> nodes_;
    std::size_t known_ = 0;          ///< nodes that are set, the latest last
    HermitePolynomial wide_;         ///< through all nodes
    HermitePolynomial near_;         ///< through two
    bool fitted_ = false;            ///< `wide_`, to the nodes of now
    bool even_ = true;               ///< no step of theirs is much longer than another
    const Node* between_ = nullptr;  ///< this one and the next the polynomial has been chosen for
    HermitePolynomial* chosen_ = nullptr;
    std::vector<double> y_;  ///< between steps, by a method's own polynomial
    std::vector<double> flat_;
};

}  // namespace jw
