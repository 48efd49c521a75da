#pragma once

#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/integrate/time_stepper.hpp"
#include "core/numerics/hermite.hpp"

/// Dense output: states at given times, between the steps of an integrator.
namespace jw {

/// Samples of a trajectory. They are taken from polynomials of degree 11 through four ends of steps, where
/// positions and their first two derivatives are known, so that no evaluation is needed; the error, (step)¹²,
/// is below that of the methods. Where steps differ much in length, the polynomial goes through
/// only the two adjacent ends if the farther ones would distort it. If a polynomial through three ends
/// differs by more than the tolerance, as where a force changes within a step, samples are integrated from
/// the end of the previous step instead. Methods with a polynomial of their own (implicit ones, whose
/// accelerations are less exact than their positions) provide it instead.
///
/// A polynomial does not satisfy the constraints. Every state is checked: a state that misses them by more
/// than the tolerance is projected onto them or, if that is not a small change, integrated from the end of
/// the previous step. If the result still does not belong to this motion, neither it nor any later state is
/// given out.
class Sampler {
public:
    using Receive = std::function<void(double t, const std::vector<double>& y)>;

    /// Calls `receive` once per time, in order, as soon as its state is known; `times` ascend. States passed
    /// to it are flat (flat_state.hpp) for any coordinates of `equations`, which must outlive this.
    /// @param tolerance of Φ divided by the size of its equation, and of Φq q̇ - ν divided by the fastest
    ///        motion as well; infinite where the motion may leave the constraints
    Sampler(
        MotionEquations& equations, std::vector<double> times, Receive receive,
        double tolerance = std::numeric_limits<double>::infinity())
        : equations_(&equations),
          times_(std::move(times)),
          receive_(std::move(receive)),
          tolerance_(tolerance) {}

    /// Takes the state of the stepper into account: to be called at the start and after every step. `stepper`
    /// must outlive the last call.
    void take(TimeStepper& stepper);
    /// Marks a discontinuity: no polynomial reaches across the end of the last step.
    void begin_anew();
    /// Gives out the remaining samples after the last step.
    void finish();
    /// First time whose state could not be determined; no later state is given out.
    std::optional<double> ended() const { return ended_; }

private:
    using Node = HermitePolynomial::Node;
    static constexpr std::size_t kNodes = HermitePolynomial::kMostNodes;

    void give_until(double t_end);
    void give_by_method(double t_end);
    /// Finds y_ at `t`, between the ends of steps. @return false if there is no state of this motion
    bool find_between(double t);
    bool is_smooth(double t);
    bool correct(double t);
    bool step_to(double t);
    void interpolate(double t);
    HermitePolynomial& polynomial_at(double t);
    HermitePolynomial& polynomial_between(const Node* ends);
    const Node& node_before(double t) const;
    void read(const Node& node, std::vector<double>& y) const;
    /// True if a state, in the numbers of the equations, meets the tolerance.
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
    std::size_t known_ = 0;          ///< number of nodes set, the latest last
    HermitePolynomial wide_;         ///< polynomial through all nodes
    HermitePolynomial near_;         ///< polynomial through two nodes
    bool fitted_ = false;            ///< whether `wide_` is fitted to the current nodes
    bool even_ = true;               ///< whether no step between nodes is much longer than another
    HermitePolynomial check_;        ///< polynomial through three nodes
    const Node* checked_ = nullptr;  ///< first of the two nodes between which it was compared
    bool smooth_ = true;             ///< whether it agreed
    const Node* between_ = nullptr;  ///< first of the two nodes for which a polynomial has been chosen
    HermitePolynomial* chosen_ = nullptr;
    std::vector<double> y_;  ///< state in the numbers of the equations
    std::vector<double> moved_;
    std::vector<double> flat_;
};

}  // namespace jw
