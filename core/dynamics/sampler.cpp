#include "core/dynamics/sampler.hpp"

#include <algorithm>
#include <utility>

namespace jw {

namespace {

using Numbers = Eigen::Matrix<double, 7, 1>;

/// Position, rate and half the acceleration of one body: r and p together.
std::array<Numbers, 3> derivatives(const double* y, const double* y_dot) {
    std::array<Numbers, 3> out;
    out[0] << vec3(y), vec4(y + 3);
    out[1] << vec3(y_dot), vec4(y_dot + 3);
    out[2] << vec3(y_dot + 7), p_ddot_of_omega_local(vec4(y + 3), vec3(y + 10), vec3(y_dot + 10));
    out[2] *= 0.5;
    return out;
}

}  // namespace

void Sampler::Polynomial::fit(std::span<const Node> nodes, std::size_t body) {
    size_ = 3 * nodes.size();
    std::array<std::array<Numbers, 3>, kNodes> known;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        known[n] = derivatives(nodes[n].y.data() + body, nodes[n].y_dot.data() + body);
    }
    std::array<Numbers, 3 * kNodes> column;
    column.fill(Numbers::Zero());
    for (std::size_t k = 0; k < size_; ++k) {
        x_[k] = nodes[k / 3].t;
        column[k] = known[k / 3][0];
    }
    coefficients_[0] = column[0];
    for (std::size_t order = 1; order < size_; ++order) {
        for (std::size_t k = size_ - 1; k >= order; --k) {
            const double width = x_[k] - x_[k - order];
            column[k] = width == 0.0 ? known[k / 3][order] : ((column[k] - column[k - 1]) / width).eval();
        }
        coefficients_[order] = column[order];
    }
}

std::pair<Numbers, Numbers> Sampler::Polynomial::value_and_rate(double t) const {
    Numbers value = coefficients_[size_ - 1];
    Numbers rate = Numbers::Zero();
    for (std::size_t k = size_ - 1; k-- > 0;) {
        rate = rate * (t - x_[k]) + value;
        value = value * (t - x_[k]) + coefficients_[k];
    }
    return {value, rate};
}

void Sampler::take(const TimeStepper& stepper) {
    if (known_ == kNodes) {
        std::rotate(nodes_.begin(), nodes_.begin() + 1, nodes_.end());
        --known_;
    }
    Node& node = nodes_[known_++];
    fitted_ = false;
    node.t = stepper.t();
    const std::size_t bodies = stepper.y().size() / static_cast<std::size_t>(equations_->numbers_per_body());
    node.y.resize(bodies * kNumbersPerBody);
    node.y_dot.resize(node.y.size());
    equations_->to_flat(stepper.y().data(), node.y.data());
    equations_->rates_to_flat(stepper.y().data(), stepper.y_dot().data(), node.y_dot.data());
    y_.resize(node.y.size());
    if (known_ == 1) {
        // the start itself
        while (next_ < times_.size() && times_[next_] <= node.t) { receive_(times_[next_++], node.y); }
        return;
    }
    if (stepper.interpolate(node.t, y_.data())) {
        for (; next_ < times_.size() && times_[next_] <= node.t; ++next_) {
            if (times_[next_] == node.t) {
                y_ = node.y;
            } else {
                stepper.interpolate(times_[next_], y_.data());
            }
            receive_(times_[next_], y_);
        }
        return;
    }
    // one step behind: times between the two nodes in the middle are known best
    if (known_ == kNodes) { give_until(nodes_[2].t); }
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
            receive_(t, node->y);
            continue;
        }
        interpolate(t);
        receive_(t, y_);
    }
}

void Sampler::fit() {
    polynomials_.resize(y_.size() / kNumbersPerBody);
    for (std::size_t n = 0; n < polynomials_.size(); ++n) {
        polynomials_[n].fit(std::span(nodes_).first(known_), n * kNumbersPerBody);
    }
    fitted_ = true;
}

void Sampler::interpolate(double t) {
    if (!fitted_) { fit(); }
    for (std::size_t n = 0; n < polynomials_.size(); ++n) {
        const auto [value, rate] = polynomials_[n].value_and_rate(t);
        double* y = body_numbers(y_.data(), n);
        const Vec4 p = value.tail<4>().normalized();
        vec3(y) = value.head<3>();
        vec4(y + 3) = p;
        vec3(y + 7) = rate.head<3>();
        vec3(y + 10) = omega_local_of(p, rate.tail<4>());
    }
}

}  // namespace jw
