#include "core/dynamics/sampler.hpp"

#include <algorithm>
#include <utility>

namespace jw {

using Meets = HermitePolynomial::Meets;

void Sampler::take(const TimeStepper& stepper) {
    if (known_ == kNodes) {
        std::rotate(nodes_.begin(), nodes_.begin() + 1, nodes_.end());
        --known_;
    }
    Node& node = nodes_[known_++];
    fitted_ = false;
    node.t = stepper.t();
    if (known_ == 1) {
        // the start itself
        flat_.resize(at(kNumbersPerBody * equations_->bodies()));
        equations_->to_flat(stepper.y().data(), flat_.data());
        while (next_ < times_.size() && times_[next_] <= node.t) { receive_(times_[next_++], flat_); }
    }
    y_.resize(stepper.y().size());
    if (stepper.has_polynomial()) {
        for (; next_ < times_.size() && times_[next_] <= node.t; ++next_) {
            if (times_[next_] == node.t) {
                y_ = stepper.y();
            } else {
                stepper.interpolate(times_[next_], y_.data());
            }
            equations_->to_flat(y_.data(), flat_.data());
            receive_(times_[next_], flat_);
        }
        return;
    }
    node.known.resize(equations_->interpolated(), 3);
    equations_->derivatives(stepper.y().data(), stepper.y_dot().data(), node.known.data());
    // one step behind: times between the two nodes in the middle are known best
    if (known_ == kNodes) { give_until(nodes_[2].t); }
}

void Sampler::begin_anew() {
    if (known_ < 2) { return; }
    finish();
    std::swap(nodes_.front(), nodes_[known_ - 1]);
    known_ = 1;
    fitted_ = false;
}

void Sampler::finish() {
    if (known_ > 0) { give_until(nodes_[known_ - 1].t); }
}

void Sampler::give_until(double t_end) {
    const std::span<const Node> known = std::span(nodes_).first(known_);
    for (; next_ < times_.size() && times_[next_] <= t_end; ++next_) {
        const double t = times_[next_];
        const auto node = std::ranges::find(known, t, &Node::t);
        if (node != known.end()) {
            equations_->flat_of(node->known.data(), node->known.col(1).data(), flat_.data());
        } else {
            interpolate(t);
        }
        receive_(t, flat_);
    }
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

/// Of `ends` and the node after it: the one of highest degree that what is nearer bears out, halfway.
HermitePolynomial& Sampler::polynomial_between(const Node* ends) {
    constexpr double agrees = 0.01;  // by the way from one end to the other; smooth steps: far below
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
    equations_->flat_of(polynomial.value().data(), polynomial.rate().data(), flat_.data());
}

}  // namespace jw
