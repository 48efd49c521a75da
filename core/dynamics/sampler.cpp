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

/// Newton's form of Hermite's polynomial through nodes that count three times each.
class Hermite {
public:
    /// @param count nodes, 2 to 4
    Hermite(const std::array<double, 4>& t, const std::array<std::array<Numbers, 3>, 4>& known, int count)
        : size_(3 * count) {
        std::array<Numbers, 12> column;
        column.fill(Numbers::Zero());
        coefficients_.fill(Numbers::Zero());
        for (int k = 0; k < size_; ++k) {
            x_[at(k)] = t[at(k / 3)];
            column[at(k)] = known[at(k / 3)][0];
        }
        coefficients_[0] = column[0];
        for (int order = 1; order < size_; ++order) {
            for (int k = size_ - 1; k >= order; --k) {
                const double width = x_[at(k)] - x_[at(k - order)];
                column[at(k)] = width == 0.0 ? known[at(k / 3)][at(order)]
                                             : ((column[at(k)] - column[at(k - 1)]) / width).eval();
            }
            coefficients_[at(order)] = column[at(order)];
        }
    }

    std::pair<Numbers, Numbers> value_and_rate(double t) const {
        Numbers value = coefficients_[at(size_ - 1)];
        Numbers rate = Numbers::Zero();
        for (int k = size_ - 2; k >= 0; --k) {
            rate = rate * (t - x_[at(k)]) + value;
            value = value * (t - x_[at(k)]) + coefficients_[at(k)];
        }
        return {value, rate};
    }

private:
    static std::size_t at(int k) { return static_cast<std::size_t>(k); }
    int size_;
    std::array<double, 12> x_{};
    std::array<Numbers, 12> coefficients_;
};

}  // namespace

void Sampler::take(const TimeStepper& stepper) {
    if (known_ == kNodes) {
        std::rotate(nodes_.begin(), nodes_.begin() + 1, nodes_.end());
        --known_;
    }
    Node& node = nodes_[static_cast<std::size_t>(known_++)];
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
    if (known_ > 0) { give_until(nodes_[static_cast<std::size_t>(known_ - 1)].t); }
}

void Sampler::give_until(double t_end) {
    for (; next_ < times_.size() && times_[next_] <= t_end; ++next_) {
        const double t = times_[next_];
        const auto node = std::ranges::find(nodes_.begin(), nodes_.begin() + known_, t, &Node::t);
        if (node != nodes_.begin() + known_) {
            receive_(t, node->y);
            continue;
        }
        interpolate(t);
        receive_(t, y_);
    }
}

void Sampler::interpolate(double t) {
    std::array<double, kNodes> times{};
    std::array<std::array<Numbers, 3>, kNodes> known;
    for (std::size_t first = 0; first < y_.size(); first += kNumbersPerBody) {
        for (std::size_t n = 0; n < static_cast<std::size_t>(known_); ++n) {
            times[n] = nodes_[n].t;
            known[n] = derivatives(nodes_[n].y.data() + first, nodes_[n].y_dot.data() + first);
        }
        const auto [value, rate] = Hermite(times, known, known_).value_and_rate(t);
        double* y = y_.data() + first;
        const Vec4 p = value.tail<4>().normalized();
        vec3(y) = value.head<3>();
        vec4(y + 3) = p;
        vec3(y + 7) = rate.head<3>();
        vec3(y + 10) = omega_local_of(p, rate.tail<4>());
    }
}

}  // namespace jw
