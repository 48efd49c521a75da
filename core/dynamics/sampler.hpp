#pragma once

#include <array>
#include <functional>
#include <limits>
#include <optional>
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
///
/// A polynomial knows nothing of constraints. Every state is put into them: what misses them by more than the
/// tolerance is moved onto them; where that is no small change, it is integrated anew from the end of a step
/// before. What does not even then belong to this motion is not given, and neither is what follows.
class Sampler {
public:
    using Receive = std::function<void(double t, const std::vector<double>& y)>;

    /// Calls `receive` once per time, in order, as soon as it is known; `times` ascend. What it gets is flat
    /// (flat_state.hpp) whatever the coordinates of `equations`, which must outlive this.
    /// @param tolerance of Φ by the sizes of its equations, and of Φq q̇ - ν by the fastest motion besides;
    ///        infinite where the motion may leave the constraints
    Sampler(
        MotionEquations& equations, std::vector<double> times, Receive receive,
        double tolerance = std::numeric_limits<double>::infinity())
        : equations_(&equations),
          times_(std::move(times)),
          receive_(std::move(receive)),
          tolerance_(tolerance) {}

    /// To be called with the start and after every step. `stepper` must outlive the last call.
    void take(TimeStepper& stepper);
    /// What follows is no smooth continuation: no polynomial reaches across the end of the last step.
    void begin_anew();
    /// After the last step: what is left.
    void finish();
    /// The first time whose state could not be told; from there on none is.
    std::optional<double> ended() const { return ended_; }

private:
    using Node = HermitePolynomial::Node;
    static constexpr std::size_t kNodes = HermitePolynomial::kMostNodes;

    void give_until(double t_end);
    void give_by_method(double t_end);
    /// y_ at `t`, which lies between the ends of steps.
    bool find_between(double t);
    bool correct(double t);
    void interpolate(double t);
    HermitePolynomial& polynomial_at(double t);
    HermitePolynomial& polynomial_between(const Node* ends);
    const Node& node_before(double t) const;
    void read(const Node& node, std::vector<double>& y) const;
    /// Of a state in the numbers of the equations.
    bool meets(double t, const std::vector<double>& y) const;
    bool meets_as_well_as_nodes(double t, const std::vector<double>& y);
    void give(double t, const std::vector<double>& y);

    MotionEquations* equations_;
    std::vector<double> times_;
    Receive receive_;
    double tolerance_;
    TimeStepper* stepper_ = nullptr;
    std::optional<double> ended_;
    std::size_t next_ = 0;
    std::array<Node, kNodes> nodes_;
    std::size_t known_ = 0;          ///< nodes that are set, the latest last
    HermitePolynomial wide_;         ///< through all nodes
    HermitePolynomial near_;         ///< through two
    bool fitted_ = false;            ///< `wide_`, to the nodes of now
    bool even_ = true;               ///< no step of theirs is much longer than another
    const Node* between_ = nullptr;  ///< this one and the next the polynomial has been chosen for
    HermitePolynomial* chosen_ = nullptr;
    std::vector<double> y_;  ///< in the numbers of the equations
    std::vector<double> moved_;
    std::vector<double> flat_;
};

}  // namespace jw
