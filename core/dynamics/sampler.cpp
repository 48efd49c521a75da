#include "core/dynamics/sampler.hpp"

#include <algorithm>
#include <utility>

namespace jw {

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
        flat_.resize(static_cast<std::size_t>(kNumbersPerBody * equations_->bodies()));
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

void Sampler::fit() {
    const std::span<const Node> nodes = std::span(nodes_).first(known_);
    const auto size = static_cast<Eigen::Index>(3 * nodes.size());
    coefficients_.resize(nodes.front().known.rows(), size);
    differences_.resize(coefficients_.rows(), size);
    for (Eigen::Index k = 0; k < size; ++k) {
        const Node& node = nodes[static_cast<std::size_t>(k / 3)];
        x_[static_cast<std::size_t>(k)] = node.t;
        differences_.col(k) = node.known.col(0);
    }
    coefficients_.col(0) = differences_.col(0);
    for (Eigen::Index order = 1; order < size; ++order) {
        for (Eigen::Index k = size - 1; k >= order; --k) {
            const double width = x_[static_cast<std::size_t>(k)] - x_[static_cast<std::size_t>(k - order)];
            if (width == 0.0) {
                differences_.col(k) = nodes[static_cast<std::size_t>(k / 3)].known.col(order);
            } else {
                differences_.col(k) = (differences_.col(k) - differences_.col(k - 1)) * (1.0 / width);
            }
        }
        coefficients_.col(order) = differences_.col(order);
    }
    value_and_rate_.resize(coefficients_.rows(), 2);
    fitted_ = true;
}

void Sampler::interpolate(double t) {
    if (!fitted_) { fit(); }
    auto value = value_and_rate_.col(0);
    auto rate = value_and_rate_.col(1);
    Eigen::Index k = coefficients_.cols() - 1;
    value = coefficients_.col(k);
    rate.setZero();
    while (k-- > 0) {
        const double way = t - x_[static_cast<std::size_t>(k)];
        rate = rate * way + value;
        value = value * way + coefficients_.col(k);
    }
    equations_->flat_of(value.data(), rate.data(), flat_.data());
}

}  // namespace jw
