#include "core/integrate/sampler.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/motion/singular_steps.hpp"

namespace jw {

using Meets = HermitePolynomial::Meets;

namespace {

/// Least tolerances: below them only rounding would be compared. Velocities lose more digits near singular
/// positions.
constexpr double kLeastOff = 1e-11;
constexpr double kLeastRateOff = 1e-8;

}  // namespace

void Sampler::take(TimeStepper& stepper) {
    stepper_ = &stepper;
    if (known_ == kNodes) {
        std::rotate(nodes_.begin(), nodes_.begin() + 1, nodes_.end());
        --known_;
    }
    Node& node = nodes_[known_++];
    fitted_ = false;
    checked_ = nullptr;
    node.t = stepper.t();
    y_.resize(stepper.y().size());
    flat_.resize(at(kNumbersPerBody * equations_->bodies()));
    if (known_ == 1) {
        // the start itself
        while (!ended_ && next_ < times_.size() && times_[next_] <= node.t) {
            give(times_[next_], stepper.y());
        }
    }
    if (stepper.has_polynomial()) {
        give_by_method(node.t);
        return;
    }
    node.known.resize(equations_->interpolated(), 3);
    equations_->derivatives(stepper.y().data(), stepper.y_dot().data(), node.known.data());
    // samples are one step late: the polynomial is most accurate between the two middle nodes
    if (known_ == kNodes) { give_until(nodes_[2].t); }
}

void Sampler::give(double t, const std::vector<double>& y) {
    equations_->to_flat(y.data(), flat_.data());
    ++next_;
    receive_(t, flat_);
}

void Sampler::give_by_method(double t_end) {
    for (; !ended_ && next_ < times_.size() && times_[next_] <= t_end;) {
        const double t = times_[next_];
        if (t == t_end) {
            give(t, stepper_->y());
        } else if (stepper_->interpolate(t, y_.data())) {
            give(t, y_);
        } else {
            ended_ = t;
        }
    }
}

void Sampler::begin_anew() {
    if (known_ < 2) { return; }
    finish();
    std::swap(nodes_.front(), nodes_[known_ - 1]);
    known_ = 1;
    fitted_ = false;
    checked_ = nullptr;
}

void Sampler::finish() {
    if (known_ > 0) { give_until(nodes_[known_ - 1].t); }
}

void Sampler::give_until(double t_end) {
    while (!ended_ && next_ < times_.size() && times_[next_] <= t_end) {
        const double t = times_[next_];
        const std::span<const Node> known = std::span(nodes_).first(known_);
        const auto node = std::ranges::find(known, t, &Node::t);
        if (node != known.end()) {
            read(*node, y_);
            if (!meets(t, y_)) { equations_->project(t, y_.data()); }
            give(t, y_);
        } else if (find_between(t)) {
            give(t, y_);
        } else {
            ended_ = t;
        }
    }
}

void Sampler::read(const Node& node, std::vector<double>& y) const {
    equations_->state_of(node.known.data(), node.known.col(1).data(), y.data());
}

const Sampler::Node& Sampler::node_before(double t) const {
    std::size_t k = known_ - 1;
    while (k > 0 && nodes_[k].t > t) { --k; }
    return nodes_[k];
}

bool Sampler::find_between(double t) {
    if (!is_smooth(t) && step_to(t)) { return true; }
    interpolate(t);
    return meets(t, y_) || correct(t) || meets_as_well_as_nodes(t, y_);
}

/// Replaces the polynomial's state by its projection onto the constraints, or by that of a separate step.
bool Sampler::correct(double t) {
    const StateScales* scales = stepper_->scales();
    moved_ = y_;
    equations_->project(t, moved_.data());
    const bool near = scales == nullptr || scales->difference(moved_.data(), y_.data()) <= kOneMotion;
    if (near && meets_as_well_as_nodes(t, moved_)) {
        y_ = moved_;
        return true;
    }
    return step_to(t);
}

/// Finds the state by a separate step from the end of the previous one.
bool Sampler::step_to(double t) {
    const Node& before = node_before(t);
    std::vector<double> start(y_.size());
    read(before, start);
    moved_.resize(y_.size());
    if (!stepper_->reach(before.t, start, t, moved_.data()) || !meets_as_well_as_nodes(t, moved_)) {
        return false;
    }
    y_ = moved_;
    return true;
}

/// True if the polynomial between the two ends around `t` agrees halfway with one through three ends, to ten
/// tolerances: its own error is far smaller.
bool Sampler::is_smooth(double t) {
    constexpr double agrees = 10.0;
    constexpr std::size_t ends = 3;
    const StateScales* scales = stepper_->scales();
    if (scales == nullptr || !std::isfinite(tolerance_) || known_ < ends) { return true; }
    const Node& before = node_before(t);
    if (checked_ == &before) { return smooth_; }
    checked_ = &before;
    const auto k = static_cast<std::size_t>(&before - nodes_.data());
    check_.fit(
        std::span(nodes_).subspan(k + ends <= known_ ? k : k - 1, ends), Meets::second_derivatives_too);
    const double halfway = before.t + 0.5 * (nodes_[k + 1].t - before.t);
    check_.evaluate(halfway);
    moved_.resize(y_.size());
    equations_->state_of(check_.value().data(), check_.rate().data(), moved_.data());
    interpolate(halfway);
    smooth_ = scales->difference(moved_.data(), y_.data()) <= agrees * std::max(tolerance_, kLeastRateOff);
    return smooth_;
}

bool Sampler::meets(double t, const std::vector<double>& y) const {
    if (!std::isfinite(tolerance_) || equations_->rows() == 0) { return true; }
    const auto [position, velocity] = equations_->violation(t, y.data());
    const StateScales* scales = stepper_->scales();
    const double fastest = scales != nullptr ? scales->omega() : std::numeric_limits<double>::infinity();
    return position <= std::max(tolerance_, kLeastOff) &&
           velocity <= std::max(tolerance_, kLeastRateOff) * fastest;
}

/// True if a state meets the constraints as well as the ends of its step do. Redundant rows hold only to the
/// precision of the typed lesson, between steps as at their ends.
bool Sampler::meets_as_well_as_nodes(double t, const std::vector<double>& y) {
    if (meets(t, y)) { return true; }
    if (equations_->rows_left_out() == 0) { return false; }
    constexpr double twice = 2.0;
    const Node* ends[] = {&node_before(t), &node_before(t) + 1};
    std::pair<double, double> most{0.0, 0.0};
    std::vector<double> there(y.size());
    for (const Node* node : ends) {
        read(*node, there);
        const auto off = equations_->violation(node->t, there.data());
        most = {std::max(most.first, off.first), std::max(most.second, off.second)};
    }
    const auto [position, velocity] = equations_->violation(t, y.data());
    return position <= twice * most.first + tolerance_ && velocity <= twice * most.second + tolerance_;
}

HermitePolynomial& Sampler::polynomial_at(double t) {
    constexpr double uneven = 20.0;
    const std::span<const Node> nodes = std::span(nodes_).first(known_);
    if (!fitted_) {
        wide_.fit(nodes, Meets::second_derivatives_too);
        double shortest = nodes[1].t - nodes[0].t;
        double longest = shortest;
        for (std::size_t k = 2; k < nodes.size(); ++k) {
            shortest = std::min(shortest, nodes[k].t - nodes[k - 1].t);
            longest = std::max(longest, nodes[k].t - nodes[k - 1].t);
        }
        even_ = longest <= uneven * shortest;
        between_ = nullptr;
        fitted_ = true;
    }
    if (even_) { return wide_; }
    const auto after = std::ranges::find_if(nodes, [&](const Node& node) { return node.t > t; });
    const Node* before = &*(after - 1);
    if (between_ != before) {
        between_ = before;
        chosen_ = &polynomial_between(before);
    }
    return *chosen_;
}

/// Polynomial between `ends` and the node after it: the one of highest degree that agrees halfway with one
/// through nearer data.
HermitePolynomial& Sampler::polynomial_between(const Node* ends) {
    // share of the displacement from one end to the other; smooth steps are far below
    constexpr double agrees = 0.01;
    const std::span<const Node> two(ends, 2);
    const double h = two[1].t - two[0].t;
    const double halfway = two[0].t + 0.5 * h;
    const double way = h * (two[0].known.col(1).matrix().norm() + two[1].known.col(1).matrix().norm());
    near_.fit(two, Meets::values_and_rates);
    near_.evaluate(halfway);
    const Eigen::ArrayXd cubic = near_.value();
    near_.fit(two, Meets::second_derivatives_too);
    near_.evaluate(halfway);
    wide_.evaluate(halfway);
    const auto agree = [&](const auto& a, const auto& b) { return (a - b).matrix().norm() <= agrees * way; };
    if (agree(wide_.value(), near_.value())) { return wide_; }
    if (!agree(near_.value(), cubic)) { near_.fit(two, Meets::values_and_rates); }
    return near_;
}

void Sampler::interpolate(double t) {
    HermitePolynomial& polynomial = polynomial_at(t);
    polynomial.evaluate(t);
    equations_->state_of(polynomial.value().data(), polynomial.rate().data(), y_.data());
}

}  // namespace jw
