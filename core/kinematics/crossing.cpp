#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/elementary/elementary.hpp"
#include "core/kinematics/motion_tracker.hpp"
#include "core/kinematics/paths/cubic_path.hpp"
#include "core/kinematics/turning_point.hpp"

/// Poses at which no step can be proved: change points, which the motion crosses, and those at which it ends,
/// with the cause.
namespace jw {

namespace {

// poses before a change point whose margins are compared, and the ratio of the margins of successive poses
constexpr std::size_t kMostRemembered = 40;
constexpr double kNearer = 0.8;
constexpr double kApart = 2.0;
// The error of a pose is rounding divided by its margin: 1e-9 at 5e-7, so the margin is known to 1 in 500.
// Nearer poses are used only if too few others are known.
constexpr double kExactMargin = 5e-7;
constexpr double kLeastMargin = 1e-300;
// largest minimum of the parabola, as a share of its value at the pose, that counts as zero
constexpr double kDoubleRoot = 0.1;

// [rad, or units of length]: far enough for a clear singular value, near enough to be beside the pose
constexpr double kBeside = 1e-2;
// [rad], not a fraction of a turn: gives numbers of a motion without symmetry
constexpr double kNoSymmetry = 2.4;

}  // namespace

/// True if the cubic path between two poses satisfies the equations in its middle.
bool MotionTracker::satisfies_between(const MotionFrame& from, const MotionFrame& to) {
    const State middle =
        middle_of(*system_, {from.t, &from.state, &from.velocity}, {to.t, &to.state, &to.velocity});
    return satisfies(newton_.assembler(), middle, 0.5 * (from.t + to.t), kCrossed);
}

/// Largest rank beside the pose, in both directions along a free motion that mixes all free motions.
int MotionTracker::rank_beside() {
    Motion any = zero_motion(system_->mechanism());
    double phase = 0.0;
    const auto next = [&] { return elementary::cos(phase += kNoSymmetry); };
    for (const int body : system_->moving_bodies()) {
        for (int k = 0; k < 3; ++k) {
            any.r_dot[at(body)](k) = next() * system_->length_unit();
            any.omega_local[at(body)](k) = next();
        }
    }
    const Layout<OmegaLocal> layout(*system_);
    const auto columns_of = [&](const Motion& motion) { return layout.columns_of(frame_.state, motion); };
    const VectorX free = columns_of(kinematics_.solve_velocity(any).velocity) -
                         columns_of(kinematics_.solve_velocity(zero_motion(system_->mechanism())).velocity);
    Kinematics<OmegaLocal> beside(*system_);
    int rank = 0;
    for (const double step : {kBeside, -kBeside}) {
        State state = frame_.state;
        layout.advance(state, step * free);
        if (!solve_position<OmegaLocal>(*system_, state, frame_.t).ok()) { continue; }
        beside.set_state(state, frame_.t);
        rank = std::max(rank, beside.rank());
    }
    return rank;
}

/// False where rounding hides the branch: no step can be proved.
bool MotionTracker::is_decided() { return proof_.decides_at({frame_.t, &frame_.state, &path_velocity_}); }

/// Root of the margin squared. Where branches meet or come near to each other, the square is a parabola of
/// time: with a double root at a change point, and without a root where branches pass each other. At a
/// turning point, the root is simple.
MotionTracker::Root MotionTracker::find_root() {
    const auto margin_at = [&](double time, const State& state, const Motion& velocity) {
        proof_.decides_at({time, &state, &velocity});
        return proof_.margin();
    };
    const double nearest = margin_at(frame_.t, frame_.state, path_velocity_);
    std::array<double, 3> t{};
    std::array<double, 3> q{};
    std::size_t found = 0;
    const auto find = [&](double least) {
        found = 0;
        const auto add = [&](double time, double margin) {
            if (margin < least) { return; }
            t[found] = time;
            q[found++] = margin * margin;
            least = kApart * margin;
        };
        add(frame_.t, nearest);
        for (auto pose = latest_.rbegin(); pose != latest_.rend() && found < t.size(); ++pose) {
            add(pose->t, margin_at(pose->t, pose->state, pose->velocity));
        }
        return found == t.size();
    };
    if (!find(kExactMargin) && !find(kLeastMargin)) { return {}; }
    const double slope = (q[1] - q[0]) / (t[1] - t[0]);
    const double bend = ((q[2] - q[1]) / (t[2] - t[1]) - slope) / (t[2] - t[0]);
    // q0 + slope0 (t - t0) + bend (t - t0)²
    const double slope_0 = slope - bend * (t[1] - t[0]);
    const double least = q[0] - slope_0 * slope_0 / (4.0 * bend);
    const double known = std::max(nearest, kExactMargin);
    if (bend > 0.0 && std::abs(least) < kDoubleRoot * std::min(q[0], known * known)) {
        return {Root::Kind::double_root, frame_.t};
    }
    const double until =
        -2.0 * q[0] /
        (slope_0 + std::copysign(std::sqrt(std::max(slope_0 * slope_0 - 4.0 * bend * q[0], 0.0)), slope_0));
    const bool is_ahead = until * (t[0] - t[1]) > 0.0;
    if (is_ahead && (bend <= 0.0 || least < 0.0)) {
        const double root = t[0] + until;
        return {Root::Kind::simple_root, until > 0.0 ? std::max(root, frame_.t) : std::min(root, frame_.t)};
    }
    return {};
}

/// Keeps the last poses of the approach, each nearer to the singular pose than the previous one: at the end
/// of the approach, rounding makes steps so short that they come no nearer.
void MotionTracker::remember() {
    const double margin = proof_.margin_nearby();
    while (!latest_.empty() && margin > latest_.back().margin) { latest_.pop_back(); }
    if (!latest_.empty() && margin > kNearer * latest_.back().margin) { return; }
    if (latest_.size() >= kMostRemembered) { latest_.erase(latest_.begin()); }
    latest_.push_back({frame_.t, frame_.state, path_velocity_, margin});
}

/// Continues along the tangent where rounding hides the branch, towards time `t`, but at most by kCrossing.
bool MotionTracker::cross(double t) {
    if (!is_crossing_ && !latest_.empty() && find_root().kind != Root::Kind::double_root) { return false; }
    double speed = 1e-300;
    for (const int body : system_->moving_bodies()) {
        const auto b = static_cast<std::size_t>(body);
        speed = std::max(
            {speed, frame_.velocity.r_dot[b].norm() / system_->length_unit(),
             frame_.velocity.omega_local[b].norm()});
    }
    const double whole = t - frame_.t;
    const double h = std::copysign(std::min(std::abs(whole), kCrossing / speed), whole);
    const double from = frame_.t;
    if (!try_thorough_step(h, Way::crossing)) { return false; }
    if (!is_crossing_) { crossings_.push_back(from); }
    is_crossing_ = true;
    restart_quick_way();
    return true;
}

void MotionTracker::explain_end(double t) {
    if (!failure_) {  // only quick steps were rejected
        failure_ = PositionFailure{};
        failure_->t = frame_.t;
    }
    const Root root = is_driven_ ? find_root() : Root{};
    if (root.kind == Root::Kind::simple_root) {
        const double sense = t > frame_.t ? 1.0 : -1.0;
        failure_->t = root.t;
        if (turns_back(*system_, frame_.state, path_velocity_, frame_.t, sense)) {
            failure_->cause = FailureCause::turning_point;
        } else if (only_moving_driver(*system_, frame_.t) == nullptr) {  // no proof is known
            failure_->cause = FailureCause::likely_turning_point;
        } else {  // the motion may continue just beside a turning point
            failure_->cause = FailureCause::undecided;
            failure_->t = frame_.t;
        }
        return;
    }
    // one small step past a dead end, the gap is too small for a verdict, so it is determined at `t` whether
    // the parts can meet
    PositionFailure there = diagnose(*system_, frame_.state, frame_.state, t, failure_->iterations);
    if (there.cause == FailureCause::cannot_close) {
        failure_ = std::move(there);
        return;
    }
    if (is_driven_ ? !is_decided() : is_start_ && full_rank_ < rank_beside_) {
        failure_->cause = FailureCause::undecided;
        failure_->t = frame_.t;
    }
}

}  // namespace jw
