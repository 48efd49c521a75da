#pragma once

#include <vector>

#include "core/model/mechanism.hpp"
#include "core/numerics/hermite.hpp"

namespace jw {

/// Angles of joints along a motion. A pose gives an angle only up to whole turns, in (-π, π]; the motion
/// determines how many turns it has made. It begins within half a turn; a driven angle begins at the value of
/// its driver. From one pose to the next, the rates determine the turns. So poses must be so near that rates
/// and accelerations at both predict the angle to half a turn, as they do for consecutive steps of a tracker
/// or an integrator.
class FollowedAngles {
public:
    /// @param mechanism must outlive this
    explicit FollowedAngles(const Mechanism& mechanism);

    /// Begins a motion at a pose.
    void begin(double t, const State& state, const Motion& velocity, const Motion& acceleration);
    /// Continues to the next pose of the motion, later or earlier.
    void reach(double t, const State& state, const Motion& velocity, const Motion& acceleration);
    /// Whole turns of every joint at the last pose, 0 for joints without an angle: the angle of the joint is
    /// that of the pose plus 2π times this.
    const std::vector<int>& turns() const { return turns_; }
    /// Whole turns at a pose between two of the last four.
    std::vector<int> turns_at(double t, const State& state) const;

private:
    using Node = HermitePolynomial::Node;

    void add_node(double t, const State& state, const Motion& velocity, const Motion& acceleration);
    template <class F>
    void take_turns(F&& expected);

    const Mechanism* mechanism_;
    std::vector<int> joints_;   ///< joints that have an angle
    std::vector<Node> latest_;  ///< angles in the order of `joints_`, turns included [rad]
    std::vector<int> turns_;    ///< one per joint of the mechanism
};

}  // namespace jw
