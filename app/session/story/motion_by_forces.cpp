#include <algorithm>
#include <optional>
#include <utility>

#include "app/session/story/dynamics_run.hpp"
#include "app/session/story/motion_telling.hpp"
#include "app/session/story/taking_part.hpp"
#include "core/motion/spring_turns.hpp"

namespace jw {

namespace {

// most steps of a story, which is told again at every change: a scene made stiff or endless ends early
constexpr long kMostStepsOfStory = 10'000;
// of all bodies in all moments of a curve: more would take hundreds of megabytes
constexpr int kMostPosesOfCurve = 100'000;

/// Moments of the curve from one step to the next: a power of two, so that the times of the steps are the
/// same to the last bit whether there is a curve or not.
int moments_between(const StoryOptions& options, int intervals, const Mechanism& mechanism) {
    const auto bodies = static_cast<int>(mechanism.bodies.size());
    const int most = std::max(1, kMostPosesOfCurve / (bodies * intervals));
    int between = 1;
    while (intervals * between < options.curve_moments && 2 * between <= most) { between *= 2; }
    return between;
}

constexpr double kFullMatrix = 0.03;  // factor of the cube of the number of bodies, see work_of_piece

class MotionByForces : public MotionTelling {
public:
    MotionByForces(const Assembled& from, const MotionPlan& plan, const StoryOptions& options)
        : lesson_(&from.lesson),
          end_(plan.to),
          assembled_(placed_at(taking_part(from.lesson), from.state)),
          start_(from.state),
          settings_(settings_of(from.lesson)),
          simulation_(assembled_, from.lesson.dynamics->loads, settings_),
          centroidal_(std::make_shared<const Centroidal>(simulation_.scene())),
          counts_turns_(depends_on_turns(centroidal_->loads)),
          system_(*from.system),
          shared_(from.system) {
        const int intervals = options.intervals > 0 ? options.intervals : plan.steps;
        between_ = moments_between(options, intervals, assembled_);
        simulation_.follow_angles();
        run_.emplace(
            simulation_, equal_times(plan.to, intervals * between_),
            [this](double t, const std::vector<double>& y) { receive(t, y); });
    }

    bool go_on(std::vector<Step>& steps, std::vector<Step>& curve) override {
        if (!run_) { return false; }
        const bool goes_on = run_->step();
        std::optional<SimulationFailure> failure;
        if (!goes_on) {
            failure = run_->finish().failure;
            run_.reset();
        }
        std::ranges::move(curve_, std::back_inserter(curve));
        std::ranges::move(steps_, std::back_inserter(steps));
        curve_.clear();
        steps_.clear();
        if (failure) { tell_end(*failure, steps, curve); }
        return true;
    }
    double progress() const override { return run_ ? told_until_ / end_ : 1.0; }
    /// An implicit step factors a full matrix: with 60 bodies it takes as long as a hundred joints do.
    double work_of_piece() const override {
        const auto bodies = static_cast<double>(assembled_.bodies.size());
        const bool is_implicit = entry_of(settings_.method).kind == MethodKind::radau;
        return is_implicit ? bodies + kFullMatrix * bodies * bodies * bodies : bodies;
    }

private:
    static SimulationSettings settings_of(const Lesson& lesson) {
        SimulationSettings settings = request_of(lesson).settings;
        settings.most_steps = kMostStepsOfStory;
        return settings;
    }

    Step moment() const {
        Step step;
        step.kind = Step::Kind::motion;
        step.additions = static_cast<int>(lesson_->order.size());
        step.system = shared_;
        return step;
    }

    /// Takes a sample of the run: a moment of the curve, and every `between_`-th time a step.
    void receive(double t, const std::vector<double>& y) {
        const Snapshot snapshot = simulation_.snapshot(t, y);
        const bool switched_now = system_.choose_rows(snapshot.state);
        if (switched_now) { shared_ = std::make_shared<System>(system_); }
        switched_ = switched_ || switched_now;
        Step step = moment();
        if (t == 0.0) { step.note = start_note(assembled_, snapshot); }
        step.rows_switched = switched_now;
        step.t = t;
        step.state = snapshot.state;
        step.velocity = snapshot.velocity;
        step.turns = snapshot.turns;
        step.centroidal_acceleration = simulation_.acceleration(t, y);
        step.acceleration = simulation_.acceleration_as_given(y, step.centroidal_acceleration);
        step.velocity_verdict.unique = step.acceleration_verdict.unique = true;
        // only the run knows the turns of springs that have been wound up
        if (counts_turns_) { centroidal_ = std::make_shared<const Centroidal>(simulation_.scene()); }
        step.centroidal = centroidal_;
        step.energy = Energy{snapshot.kinetic, snapshot.potential};
        if (between_ > 1) { curve_.push_back(step); }
        told_until_ = t;
        if (samples_++ % between_ != 0) { return; }
        step.rows_switched = switched_;
        switched_ = false;
        if (run_ && run_->bodies_from() && !std::exchange(bodies_told_, true)) {
            step.note = bodies_note(*run_->bodies_from());
        }
        steps_.push_back(std::move(step));
    }

    void tell_end(
        const SimulationFailure& failure, std::vector<Step>& steps, const std::vector<Step>& curve) const {
        if (steps.back().kind != Step::Kind::motion) {
            Step start = moment();
            start.state = start_;
            start.velocity = start_motion(assembled_);
            start.acceleration = zero_motion(assembled_);
            steps.push_back(std::move(start));
        }
        // if the motion ends between two steps, the last moment is shown
        if (!curve.empty() && curve.back().t > steps.back().t) { steps.push_back(curve.back()); }
        steps.back().ended = failure_text(failure, settings_, lesson_->mechanism);
    }

    const Lesson* lesson_;
    double end_;  ///< [s]
    Mechanism assembled_;
    State start_;
    SimulationSettings settings_;
    Simulation simulation_;
    std::shared_ptr<const Centroidal> centroidal_;
    bool counts_turns_;
    System system_;
    std::shared_ptr<const System> shared_;
    int between_ = 1;  ///< samples from one step to the next
    int samples_ = 0;
    double told_until_ = 0.0;   ///< [s]
    bool switched_ = false;     ///< a choice of rows has changed since the last step
    bool bodies_told_ = false;  ///< a note has said that the run left the coordinates of the joints
    std::vector<Step> steps_;   ///< received and not yet passed on
    std::vector<Step> curve_;
    std::optional<SimulationRun> run_;
};

}  // namespace

std::unique_ptr<MotionTelling> tell_motion_by_forces(
    const Assembled& from, const MotionPlan& plan, const StoryOptions& options) {
    return std::make_unique<MotionByForces>(from, plan, options);
}

}  // namespace jw
