#include "app/session/story/motion_telling.hpp"
#include "core/kinematics/motion_tracker.hpp"

namespace jw {

namespace {

class PrescribedMotion : public MotionTelling {
public:
    PrescribedMotion(const Assembled& from, const MotionPlan& plan, const StoryOptions& options)
        : lesson_(&from.lesson),
          plan_(plan),
          intervals_(options.intervals > 0 ? options.intervals : plan.steps),
          shared_(from.system),
          system_(*from.system),
          tracker_(system_, from.state, start_time(from.lesson)) {}

    bool go_on(std::vector<Step>& steps, std::vector<Step>& /*curve*/) override {
        if (moment_ > intervals_) { return false; }
        const double t = plan_.from + (plan_.to - plan_.from) * moment_ / intervals_;
        bool switched = false;
        const bool ok = moment_ == 0 || advance_along(tracker_, *lesson_, t, switched);
        if (switched) { shared_ = std::make_shared<System>(system_); }
        steps.push_back(present(switched));
        if (!ok) { steps.back().failure = tracker_.failure(); }
        moment_ = ok ? moment_ + 1 : intervals_ + 1;
        return true;
    }
    double progress() const override { return static_cast<double>(moment_) / (intervals_ + 1); }
    double work_of_piece() const override { return static_cast<double>(lesson_->mechanism.bodies.size()); }

private:
    Step present(bool switched) const {
        const MotionFrame& frame = tracker_.frame();
        Step step;
        step.kind = Step::Kind::motion;
        step.additions = static_cast<int>(lesson_->order.size());
        step.system = shared_;
        step.t = frame.t;
        step.state = frame.state;
        step.velocity = frame.velocity;
        step.acceleration = frame.acceleration;
        step.turns = frame.turns;
        step.rows_switched = switched;
        step.change_point = frame.change_point;
        step.velocity_verdict = frame.velocity_verdict;
        step.acceleration_verdict = frame.acceleration_verdict;
        return step;
    }

    const Lesson* lesson_;
    MotionPlan plan_;
    int intervals_ = 1;
    int moment_ = 0;
    std::shared_ptr<const System> shared_;
    System system_;
    MotionTracker tracker_;
};

}  // namespace

std::unique_ptr<MotionTelling> tell_prescribed_motion(
    const Assembled& from, const MotionPlan& plan, const StoryOptions& options) {
    return std::make_unique<PrescribedMotion>(from, plan, options);
}

}  // namespace jw
