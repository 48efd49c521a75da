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

/// Bound of the error of angle `k` that is predicted by the mean rate between two poses, whether its rate
/// changes evenly or suddenly [rad].
double left_open(const HermitePolynomial::Node& from, const HermitePolynomial::Node& to, Eigen::Index k) {
    return 0.5 * std::abs(to.t - from.t) * std::abs(to.known(k, 1) - from.known(k, 1));
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

void FollowedAngles::add_node(
    double t, const State& state, const Motion& velocity, const Motion& acceleration) {
    // the storage of the earliest pose is used again
    if (latest_.size() == HermitePolynomial::kMostNodes) {
        std::ranges::rotate(latest_, latest_.begin() + 1);
    } else {
        latest_.emplace_back();
    }
    Node& node = latest_.back();
    node.t = t;
    node.known.resize(static_cast<Eigen::Index>(joints_.size()), 3);
    for (std::size_t k = 0; k < joints_.size(); ++k) {
        const Joint& joint = mechanism_->joints[at(joints_[k])];
        node.known.row(static_cast<Eigen::Index>(k)) << relative_angle(joint, state),
            angle_rate(joint, state, velocity),
            0.5 * angle_acceleration(joint, state, velocity, acceleration);
    }
}

void FollowedAngles::begin(double t, const State& state, const Motion& velocity, const Motion& acceleration) {
    latest_.clear();
    add_node(t, state, velocity, acceleration);
    Eigen::ArrayXd expected = latest_.back().known.col(0);
    for (const Driver& driver : mechanism_->drivers) {
        const auto k = std::ranges::find(joints_, driver.joint) - joints_.begin();
        const bool is_angle = std::holds_alternative<AngleMeasure>(driver.measure);
        if (is_angle && k < std::ssize(joints_)) { expected(k) = driver.function.at(t).f; }
    }
    turns_.assign(mechanism_->joints.size(), 0);
    take_turns([&](Eigen::Index k) { return expected(k); });
}

/// Adds the whole turns that bring the angles of the last pose nearest to `expected(k)`.
template <class F>
void FollowedAngles::take_turns(F&& expected) {
    for (std::size_t k = 0; k < joints_.size(); ++k) {
        double& angle = latest_.back().known(static_cast<Eigen::Index>(k), 0);
        const int turns = whole_turns(expected(static_cast<Eigen::Index>(k)) - angle);
        turns_[at(joints_[k])] = turns;
        angle += kTurn * turns;
    }
}

void FollowedAngles::reach(double t, const State& state, const Motion& velocity, const Motion& acceleration) {
    add_node(t, state, velocity, acceleration);
    const Node& before = latest_.end()[-2];
    const Node& node = latest_.back();
    const double h = t - before.t;
    take_turns([&](Eigen::Index k) {
        const double by_rates = before.known(k, 0) + 0.5 * h * (before.known(k, 1) + node.known(k, 1));
        // the corrected trapezoidal rule: exact for polynomials of degree four
        const double correction = h * h / 6.0 * (before.known(k, 2) - node.known(k, 2));
        return left_open(before, node, k) > kQuarterTurn ? by_rates + correction : by_rates;
    });
}

std::vector<int> FollowedAngles::turns_at(double t, const State& state) const {
    const auto after = std::ranges::find_if(latest_, [&](const Node& node) { return node.t >= t; });
    if (after == latest_.end()) { return turns_; }
    Eigen::ArrayXd expected = after->known.col(0);
    if (after->t > t && after != latest_.begin()) {
        HermitePolynomial between;
        bool asks_rates = true;
        for (Eigen::Index k = 0; k < std::ssize(joints_); ++k) {
            asks_rates = asks_rates && left_open(*(after - 1), *after, k) <= kQuarterTurn;
        }
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
