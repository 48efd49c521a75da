#include "core/kinematics/departure.hpp"

#include <algorithm>
#include <cmath>

#include "core/equations/assembler.hpp"
#include "core/kinematics/expansion.hpp"

namespace jw {

namespace {

// Largest part of a velocity outside the free motions: the error of the decomposition of Φq.
constexpr double kNotFree = 1e-6;
// Equations are assembled to rounding at best.
constexpr double kAssembled = 1e-15;
// Factor for the misfit at the pose, part of which rounding may hide.
constexpr double kRoomOfPose = 4.0;
// Number of other velocities that are expanded: a polynomial that is not zero is unlikely to vanish at any of
// a few points.
constexpr int kOthers = 3;
static_assert(kOrders == kHighestOrder + 1);

/// First coefficient that is larger than the parts of higher ones that it contains if the pose is off by δ
/// along the motion. δ is as large as the misfit at the pose allows.
std::optional<Missed> first_that_counts(const Misfits& misfits) {
    const double at_pose = kRoomOfPose * misfits[0].value + kAssembled;
    double off = 1.0;
    for (std::size_t k = 2; k < misfits.size(); ++k) {
        if (misfits[k].value == 0.0) { continue; }
        off = std::min(off, elementary::pow(at_pose / misfits[k].value, 1.0 / static_cast<double>(k)));
    }
    for (std::size_t j = 2; j < misfits.size(); ++j) {
        double explained = 0.0;
        double binomial = 1.0;
        double power = 1.0;
        for (std::size_t k = j + 1; k < misfits.size(); ++k) {
            binomial *= static_cast<double>(k) / static_cast<double>(k - j);
            power *= off;
            explained += binomial * misfits[k].value * power;
        }
        if (misfits[j].value > explained) { return misfits[j]; }
    }
    return std::nullopt;
}

/// True if no other velocity violates an equation at an order below `order`.
bool is_first(Expansion& expansion, int order) {
    if (expansion.freedoms() == 1 || order == 2) { return true; }
    for (int k = 1; k <= kOthers; ++k) {
        VectorX any(expansion.columns());
        for (Eigen::Index n = 0; n < any.size(); ++n) {
            any(n) = elementary::cos(static_cast<double>(k) + static_cast<double>(n * n));
        }
        const auto other = first_that_counts(expansion.expand(expansion.free_part(any).normalized()));
        if (other && other->order < order) { return false; }
    }
    return true;
}

/// @param scale size of the velocity along which the path was expanded
Departure described(
    const System& system, const ProvedStep& step, const Motion& velocity, const Missed& missed,
    double scale) {
    Departure d;
    d.order = missed.order;
    const auto e = at(missed.equation);
    const ProvedEquation& equation = step.equations()[e];
    const std::size_t joints = system.constraints().size();
    if (e < joints) {
        d.joint = system.constraints()[e].joint;
    } else {
        d.driver = system.drivers()[e - joints].driver;
    }
    const auto turn = [&](int body) { return velocity.omega_local[at(body)].norm(); };
    const auto shift = [&](int body) { return velocity.r_dot[at(body)].norm() / step.length(); };
    const auto speed = [&](int body) { return std::max(turn(body), shift(body)); };
    d.body = std::ranges::max(system.moving_bodies(), {}, speed);
    for (const int body : {equation.body_i, equation.body_j}) {
        if (speed(body) > kLeastSpeed * scale && step.table().of_body(body) >= 0) { d.body = body; }
    }
    double rate = turn(d.body);
    d.direction = 3;
    if (shift(d.body) >= rate) { rate = velocity.r_dot[at(d.body)].cwiseAbs().maxCoeff(&d.direction); }
    d.coefficient = missed.value * equation.unit;
    for (int k = 0; k < missed.order; ++k) { d.coefficient *= scale / rate; }
    return d;
}

}  // namespace

std::optional<Departure> find_departure(const System& system, const State& state, const VectorX& direction) {
    if (!direction.allFinite()) { return std::nullopt; }
    const Motion motion = Layout<OmegaLocal>(system).motion_of(state, direction);
    Expansion expansion(system, state, motion);
    if (!expansion.has_dependent_rows()) { return std::nullopt; }
    const VectorX velocity = expansion.velocity();
    const VectorX first = expansion.free_part(velocity);
    const double size = first.norm();
    if (!(size > 0.0) || (velocity - first).norm() > kNotFree * size) { return std::nullopt; }
    const std::optional<Missed> missed = first_that_counts(expansion.expand(first / size));
    if (!missed || !is_first(expansion, missed->order)) { return std::nullopt; }
    return described(system, expansion.step(), motion, *missed, size);
}

}  // namespace jw
