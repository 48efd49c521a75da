#include "core/kinematics/joint_angles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace jw {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

// [rad] the turns of a larger angle are not known: the run has diverged
constexpr double kMostCounted = 1e9;

int whole_turns(double angle) {
    return std::abs(angle) < kMostCounted ? static_cast<int>(std::round(angle / kTurn)) : 0;
}

/// Bound of the error of an angle that is predicted by the mean rate between two poses, whether its rate
/// changes evenly or suddenly [rad].
Eigen::ArrayXd left_open(const HermitePolynomial::Node& from, const HermitePolynomial::Node& to) {
    return 0.5 * std::abs(to.t - from.t) * (to.known.col(1) - from.known.col(1)).abs();
}
// if the bound is smaller, accelerations are not used: near singular poses they can be arbitrary
constexpr double kQuarterTurn = 0.5 * std::numbers::pi;

}  // namespace

FollowedAngles::FollowedAngles(const Mechanism& mechanism) : mechanism_(&mechanism) {
    for (int j = 0; j < static_cast<int>(mechanism.joints.size()); ++j) {
        const JointType& type = *mechanism.joints[at(j)].type;
        // θ of a screw is a coordinate, which includes its turns
        if (type.has_angle() && type.artificial == 0) { joints_.push_back(j); }
    }
}

FollowedAngles::Node FollowedAngles::node_at(
    double t, const State& state, const Motion& velocity, const Motion& acceleration) const {
    Node node{t, Eigen::ArrayX3d(static_cast<Eigen::Index>(joints_.size()), 3)};
    for (std::size_t k = 0; k < joints_.size(); ++k) {
        const Joint& joint = mechanism_->joints[at(joints_[k])];
        node.known.row(static_cast<Eigen::Index>(k)) << relative_angle(joint, state),
            angle_rate(joint, state, velocity),
            0.5 * angle_acceleration(joint, state, velocity, acceleration);
    }
    return node;
}

void FollowedAngles::begin(double t, const State& state, const Motion& velocity, const Motion& acceleration) {
    latest_.assign(1, node_at(t, state, velocity, acceleration));
    Eigen::ArrayXd expected = latest_.back().known.col(0);
    for (const Driver& driver : mechanism_->drivers) {
        const auto k = std::ranges::find(joints_, driver.joint) - joints_.begin();
        const bool is_angle = std::holds_alternative<AngleMeasure>(driver.measure);
        if (is_angle && k < std::ssize(joints_)) { expected(k) = driver.function.at(t).f; }
    }
    turns_.assign(mechanism_->joints.size(), 0);
    take_turns(expected, latest_.back());
}

/// Adds the whole turns that bring the angles of a pose nearest to the expected ones.
void FollowedAngles::take_turns(const Eigen::ArrayXd& expected, Node& node) {
    for (std::size_t k = 0; k < joints_.size(); ++k) {
        double& angle = node.known(static_cast<Eigen::Index>(k), 0);
        const int turns = whole_turns(expected(static_cast<Eigen::Index>(k)) - angle);
        turns_[at(joints_[k])] = turns;
        angle += kTurn * turns;
    }
}

void FollowedAngles::reach(double t, const State& state, const Motion& velocity, const Motion& acceleration) {
    const Node& before = latest_.back();
    Node node = node_at(t, state, velocity, acceleration);
    const double h = t - before.t;
    const Eigen::ArrayXd by_rates = before.known.col(0) + 0.5 * h * (before.known.col(1) + node.known.col(1));
    // the corrected trapezoidal rule: exact for polynomials of degree four
    const Eigen::ArrayXd correction = h * h / 6.0 * (before.known.col(2) - node.known.col(2));
    take_turns(by_rates + (left_open(before, node) > kQuarterTurn).select(correction, 0.0), node);
    if (latest_.size() == HermitePolynomial::kMostNodes) { latest_.erase(latest_.begin()); }
    latest_.push_back(std::move(node));
}

std::vector<int> FollowedAngles::turns_at(double t, const State& state) const {
    const auto after = std::ranges::find_if(latest_, [&](const Node& node) { return node.t >= t; });
    if (after == latest_.end()) { return turns_; }
    Eigen::ArrayXd expected = after->known.col(0);
    if (after->t > t && after != latest_.begin()) {
        HermitePolynomial between;
        const bool asks_rates = (left_open(*(after - 1), *after) <= kQuarterTurn).all();
        between.fit(
            std::span(&*(after - 1), 2), asks_rates ? HermitePolynomial::Meets::values_and_rates
                                                    : HermitePolynomial::Meets::second_derivatives_too);
        between.evaluate(t);
        expected = between.value();
    }
    std::vector<int> turns(turns_.size(), 0);
    for (std::size_t k = 0; k < joints_.size(); ++k) {
        const double angle = relative_angle(mechanism_->joints[at(joints_[k])], state);
        turns[at(joints_[k])] = whole_turns(expected(static_cast<Eigen::Index>(k)) - angle);
    }
    return turns;
}

}  // namespace jw
