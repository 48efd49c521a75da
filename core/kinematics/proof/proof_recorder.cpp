#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "core/kinematics/proof/part_recorder.hpp"

namespace jw {

namespace {

// points of a step at which its equations are evaluated: both ends, the middle, and the maximum of the
// residual on either side
constexpr std::size_t kSamples = 5;
// number of halvings of an interval: steps become a share of the distance from a singular pose, and the rest
// of that distance is not worth more steps
constexpr int kMostHalvings = 16;

}  // namespace

class ProofRecorder::Impl {
public:
    explicit Impl(const System& system) : system_(&system), proof_(system), step_(system), sample_(system) {
        record_.coordinates = step_.table().all();
        record_.equations = step_.equations();
        for (const DriverConstraint& d : system.drivers()) {
            system.mechanism().drivers[at(d.driver)].function.append_kinks(kinks_);
        }
        std::ranges::sort(kinks_);
    }

    void add(const MotionFrame& frame);
    ProofRecord take() { return std::move(record_); }

private:
    void reach(const MotionFrame& frame, int halvings);
    bool is_proved(const MotionFrame& to, StepRecord& step);
    NoProof reason_for_all(const MotionFrame& frame);
    std::vector<PathSample> samples();
    PathSample sample_at(double share);
    void divide(const PathSample& sample);
    void append(const MotionFrame& frame);
    std::optional<MotionFrame> frame_at(double t) const;

    const System* system_;
    StepProof proof_;
    ProvedStep step_;
    ProvedStep sample_;  ///< for points between the ends
    std::vector<double> kinks_;
    std::vector<PartRecorder> parts_;
    bool are_divided_ = false;
    MotionFrame last_;
    ProofRecord record_;
};

/// The pose at a time after the last one, as the tracker finds it; nothing if the motion has ended.
std::optional<MotionFrame> ProofRecorder::Impl::frame_at(double t) const {
    System system = *system_;
    MotionTracker tracker(system, last_.state, last_.t);
    if (!tracker.advance_to(t)) { return std::nullopt; }
    return tracker.frame();
}

PathSample ProofRecorder::Impl::sample_at(double share) {
    const State state = step_.state_at(share);
    const Motion still = zero_motion(system_->mechanism());
    const PathEnd end{step_.from().t + share * step_.h(), &state, &still};
    sample_.set(end, end);
    PathSample sample{sample_.from().phi, {}};
    for (std::size_t e = 0; e < sample_.equations().size(); ++e) {
        sample.jacobians.push_back(sample_.jacobian_at(sample_.from(), static_cast<int>(e)));
    }
    return sample;
}

std::vector<PathSample> ProofRecorder::Impl::samples() {
    std::vector<PathSample> all;
    for (std::size_t k = 0; k < kSamples; ++k) {
        all.push_back(sample_at(static_cast<double>(k) / static_cast<double>(kSamples - 1)));
    }
    return all;
}

void ProofRecorder::Impl::divide(const PathSample& sample) {
    parts_.clear();
    for (Part& part : find_parts(step_.table(), step_.equations(), sample.jacobians)) {
        if (part.columns <= kMostProvedColumns) { parts_.emplace_back(std::move(part), step_); }
    }
    are_divided_ = true;
}

/// Writes the step from the last pose into `step`.
bool ProofRecorder::Impl::is_proved(const MotionFrame& to, StepRecord& step) {
    const PathEnd from{last_.t, &last_.state, &last_.velocity};
    const PathEnd end{to.t, &to.state, &to.velocity};
    if (!proof_.holds(from, end)) { return false; }
    step_.set(from, end);
    const std::vector<PathSample> along = samples();
    if (!are_divided_) { divide(along[kSamples / 2]); }
    std::vector<double> errors(step_.table().all().size(), 0.0);
    std::size_t known = 0;
    for (PartRecorder& part : parts_) {
        if (!part.record(along, errors, step.parts.emplace_back())) {
            are_divided_ = false;
            return false;
        }
        known += part.part().unknowns.size();
    }
    if (known < errors.size()) { step.reason = NoProof::too_large; }
    return true;
}

/// Reason why nothing can be proved about this motion, or `none`.
NoProof ProofRecorder::Impl::reason_for_all(const MotionFrame& frame) {
    if (system_->drivers().empty()) { return NoProof::nothing_drives; }
    const bool is_free = proof_.leaves_bodies_free({frame.t, &frame.state, &frame.velocity});
    return is_free ? NoProof::leaves_bodies_free : NoProof::none;
}

void ProofRecorder::Impl::append(const MotionFrame& frame) {
    PoseRecord pose{frame.t, {}, {}};
    int columns = 0;
    for (const Coordinates& c : record_.coordinates) { columns += c.size; }
    pose.x.resize(columns);
    pose.x_dot.resize(columns);
    int first = 0;
    for (const Coordinates& c : record_.coordinates) {
        const auto write = [&](const auto& x, const auto& x_dot) {
            pose.x.segment(first, c.size) = x;
            pose.x_dot.segment(first, c.size) = x_dot;
        };
        if (c.theta >= 0) {
            pose.x(first) = frame.state.theta[at(c.theta)];
            pose.x_dot(first) = frame.velocity.theta_dot[at(c.theta)];
        } else if (c.size == 3) {
            write(frame.state.r[at(c.body)], frame.velocity.r_dot[at(c.body)]);
        } else {
            const Vec4& p = frame.state.p[at(c.body)];
            write(p, p_dot_of_omega_local(p, frame.velocity.omega_local[at(c.body)]));
            // p and -p are the same pose: the one nearer to the previous pose is used
            if (!record_.poses.empty() && record_.poses.back().x.segment(first, 4).dot(p) < 0.0) {
                pose.x.segment(first, 4) *= -1.0;
                pose.x_dot.segment(first, 4) *= -1.0;
            }
        }
        first += c.size;
    }
    record_.poses.push_back(std::move(pose));
    last_ = frame;
}

void ProofRecorder::Impl::reach(const MotionFrame& frame, int halvings) {
    StepRecord step;
    step.reason = reason_for_all(last_);
    if (step.reason == NoProof::none && !is_proved(frame, step)) {
        if (halvings > 0) {
            if (const auto middle = frame_at(0.5 * (last_.t + frame.t))) {
                reach(*middle, halvings - 1);
                reach(frame, halvings - 1);
                return;
            }
        }
        step = {{}, NoProof::singular};
    }
    record_.steps.push_back(std::move(step));
    append(frame);
}

void ProofRecorder::Impl::add(const MotionFrame& frame) {
    if (record_.poses.empty()) {
        record_.fixed = frame.state;
        append(frame);
        const PathEnd end{frame.t, &frame.state, &frame.velocity};
        step_.set(end, end);
        record_.rank = record_rank(step_, sample_at(0.0));
        return;
    }
    if (frame.t == last_.t) { return; }
    for (const double kink : kinks_) {
        if (kink <= last_.t || kink >= frame.t) { continue; }
        if (const auto there = frame_at(kink)) { reach(*there, kMostHalvings); }
    }
    reach(frame, kMostHalvings);
}

ProofRecorder::ProofRecorder(const System& system) : impl_(std::make_unique<Impl>(system)) {}
ProofRecorder::~ProofRecorder() = default;
void ProofRecorder::add(const MotionFrame& frame) { impl_->add(frame); }
ProofRecord ProofRecorder::take() { return impl_->take(); }

}  // namespace jw
