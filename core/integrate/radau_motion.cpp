#include <algorithm>
#include <cmath>

#include "core/elementary/elementary.hpp"
#include "core/integrate/radau.hpp"

/// Checks that the stages of a step, and the states between them, belong to the motion that led there.
namespace jw {

namespace {

/// Largest rotation of a body within a step [rad]: if drivers leave little or no freedom, the error of the
/// few independent numbers does not show that the others were skipped.
constexpr double kMostTurn = 1.0;
/// Deviation of stages from where their rates lead, as a share of the displacement and of the fastest motion.
constexpr double kMostShareOff = 0.1;
/// Rounding of acos near 1 [rad].
constexpr double kNoTurn = 1e-6;

}  // namespace

RadauIntegrator::Turning RadauIntegrator::turning_of_stages() const {
    Turning turning;
    std::vector<double> start(at(kNumbersPerBody * equations_->bodies()));
    std::vector<double> now(start.size());
    equations_->to_flat(y_.data(), start.data());
    for (Eigen::Index i = 0; i < y_stages_.cols(); ++i) {
        equations_->to_flat(y_stages_.col(i).data(), now.data());
        for (std::size_t m = 0; m < at(equations_->bodies()); ++m) {
            const double* body = body_numbers(now.data(), m);
            const Vec4 p = vec4(body + 3).normalized();
            const double cosine = std::abs(p.dot(vec4(body_numbers(start.data(), m) + 3).normalized()));
            turning.rate = std::max(turning.rate, vec3(body + 10).norm());
            turning.angle = std::max(turning.angle, 2.0 * elementary::acos(std::min(1.0, cosine)));
        }
    }
    return turning;
}

/// True if a body turned too far; sets h_ to a shorter step then. From rest, or where a driver begins to
/// turn, the rate is known only within the step; and a pose that no velocity leads to belongs to another
/// solution of the same equations.
bool RadauIntegrator::turned_too_far(double h) {
    const Turning turning = turning_of_stages();
    const double rate = std::max(fastest_turn(*equations_, y_.data(), flat_), turning.rate);
    if (turning.rate * h > 1.5 * most_turn()) {
        h_ = most_turn() / turning.rate;
        return true;
    }
    if (turning.angle <= 2.0 * rate * h + kNoTurn) { return false; }
    h_ = 0.5 * h;
    return true;
}

/// Stages y_i = y_0 + h Σ a_ij ẏ_j hold for all numbers of a motion up to the error of the method, but only
/// the independent ones are made to satisfy them. No velocity leads to a stage on another branch, or a turn
/// of a thread away.
bool RadauIntegrator::is_one_motion(double h) const {
    if (!coordinates_->are_projected()) { return true; }
    const MatrixX led = (h * y_rates_ * table_.a.transpose()).colwise() + start_numbers();
    double way = 0.0;
    double position = 0.0;
    double velocity = 0.0;
    for (Eigen::Index k = 0; k < led.rows(); ++k) {
        const double scale = scales_.of(static_cast<std::size_t>(k));
        const double off = (y_stages_.row(k) - led.row(k)).cwiseAbs().maxCoeff() / scale;
        if (k % kNumbersPerBody < kPositionsPerBody) {
            position = std::max(position, off);
            way = std::max(way, h * y_rates_.row(k).cwiseAbs().maxCoeff() / scale);
        } else {
            velocity = std::max(velocity, off);
        }
    }
    return position <= kMostShareOff * way + kMet && velocity <= kMostShareOff;
}

double RadauIntegrator::most_turn() const { return std::min(kMostTurn, options_.most_turn); }

/// Where the independent coordinates hardly determine the others, the pose that they lead to may be on
/// another branch; then the polynomial of all numbers is projected onto the constraints instead.
bool RadauIntegrator::interpolate(double t, double* y) {
    const VectorX w = weights(1.0 - (t_ - t) / last_step_);
    const VectorX estimate = y_before_ * w;
    const auto is_of_motion = [&] { return scales_.difference(y, estimate.data()) <= kMostShareOff; };
    std::copy_n(estimate.data(), estimate.size(), y);
    VectorX y_dot(estimate.size());
    VectorX x_dot(x_before_.rows());
    coordinates_->evaluate(t, x_before_ * w, y, y_dot.data(), x_dot);
    if (!coordinates_->are_projected() || (coordinates_->verdict().violation <= kMet && is_of_motion())) {
        return true;
    }
    std::copy_n(estimate.data(), estimate.size(), y);
    equations_->project(t, y);
    return equations_->evaluate(t, y, y_dot.data()).violation <= kMet && is_of_motion();
}

}  // namespace jw
