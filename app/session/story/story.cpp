#include "app/session/story/story.hpp"

#include <algorithm>
#include <cmath>

#include "app/session/story/dynamics_run.hpp"
#include "core/poses/branches.hpp"
#include "core/poses/large_rank.hpp"

namespace jw {

Selection selection_of(const Lesson& lesson, int count) {
    Selection selection;
    for (int k = 0; k < count; ++k) {
        const Addition& a = lesson.order[static_cast<std::size_t>(k)];
        (a.kind == Addition::Kind::joint ? selection.joints : selection.drivers).push_back(a.index);
    }
    return selection;
}

namespace {

// iterations shown of a solve that fails: its beginning is worth a look, sixty more of the same are not
constexpr std::size_t kFirstIterations = 6;

/// Leaves the first iterations of the last solve and the last one; the Newton table has all of them.
void thin_out_iterations(std::vector<Step>& steps) {
    std::size_t first = steps.size();
    while (first > 0 && steps[first - 1].kind == Step::Kind::iteration) { --first; }
    if (steps.size() - first <= kFirstIterations + 1) { return; }
    steps.erase(
        steps.begin() + static_cast<std::ptrdiff_t>(first + kFirstIterations), std::prev(steps.end()));
}

// limit of a story that is told again at every change: a scene that was made stiff or endless ends early
constexpr long kMostStepsOfStory = 10'000;
// their reactions are found by dense matrices
constexpr std::size_t kMostJointsWithReactions = 30;
constexpr double kNoMoment = 1e-6;  // far above rounding, 1e-13 by the forces
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

}  // namespace

std::optional<Reactions> reactions_of(const Step& step) {
    if (!step.centroidal || step.centroidal->mechanism.joints.size() > kMostJointsWithReactions) {
        return std::nullopt;
    }
    Reactions found = reactions_from_body_frames(
        *step.centroidal, step.t, step.state, step.velocity, step.centroidal_acceleration);
    // a pose that somebody has pulled elsewhere is no moment of the motion: these are not its accelerations
    if (found.residual > kNoMoment) { return std::nullopt; }
    return found;
}

std::optional<MotionPlan> shown_motion(const Lesson& lesson) {
    if (lesson.motion || !lesson.dynamics) { return lesson.motion; }
    if (!why_not(lesson.dynamics->method, lesson.dynamics->treatment).empty()) { return std::nullopt; }
    // motions shorter than the blink of an eye are shown in slow motion, long ones at their own pace
    constexpr double shortest_show = 8.0;
    MotionPlan plan;
    plan.to = lesson.dynamics->duration;
    plan.duration = std::max(plan.to, shortest_show);
    return plan;
}

double start_time(const Lesson& lesson) { return lesson.motion ? lesson.motion->from : 0.0; }

Story::Story(const Lesson& lesson, const StoryOptions& options)
    : lesson_(&lesson), with_ranks_(options.with_ranks), keep_steps_(options.keep_steps) {
    start_time_ = start_time(lesson);
    state_ = start_state(lesson.mechanism);
    tell(options);
}

void Story::tell(const StoryOptions& options) {
    const auto is_enough = [&] {
        return options.last_step >= 0 && options.last_step < static_cast<int>(steps_.size());
    };
    const auto all = static_cast<int>(lesson_->order.size());
    const int additions = options.additions < 0 ? all : std::min(options.additions, all);
    tell_bodies();
    ask(Question::Place::bodies, nullptr, Step::Kind::question);
    ask(Question::Place::bodies, nullptr, Step::Kind::answer);
    for (int count = 1; count <= additions; ++count) {
        if (is_enough()) { return; }
        const bool quiet = !keep_steps_ && count < additions && tell_quietly(count);
        if (!quiet && !tell_addition(count)) { return; }
        if (!keep_steps_) { forget_poses(); }
    }
    if (is_enough()) { return; }
    if (options.with_motion && additions == all) {
        if (const auto plan = shown_motion(*lesson_)) {
            ask(Question::Place::motion, nullptr, Step::Kind::question);
            lesson_->motion ? tell_motion(*plan, options) : tell_dynamics(*plan, options);
            if (failure() == nullptr) { ask(Question::Place::motion, nullptr, Step::Kind::answer); }
        }
    }
    find_featured_joint();
}

const Step* Story::failure() const {
    const Step& last = steps_.back();
    return last.failed() ? &last : nullptr;
}

int Story::last_assembled() const {
    int index = 0;
    for (std::size_t k = 0; k < steps_.size(); ++k) {
        if (steps_[k].kind == Step::Kind::motion) { break; }
        if (!is_asked(steps_[k].kind)) { index = static_cast<int>(k); }
    }
    return index;
}

bool advance_along(MotionTracker& tracker, const Lesson& lesson, double t, bool& rows_switched) {
    rows_switched = false;
    const auto advance = [&](double next) {
        const bool ok = tracker.advance_to(next);
        rows_switched = rows_switched || tracker.frame().rows_switched;
        return ok;
    };
    if (lesson.motion) {
        const MotionPlan& plan = *lesson.motion;
        const double interval = (plan.to - plan.from) / plan.steps;
        for (int k = 1; k <= plan.steps; ++k) {
            const double moment = plan.from + k * interval;
            // nearer than a thousandth of an interval they count as one
            if (moment <= tracker.frame().t + 1e-3 * interval || moment >= t - 1e-3 * interval) { continue; }
            if (!advance(moment)) { return false; }
        }
    }
    return advance(t);
}

void Story::find_featured_joint() {
    if (lesson_->mechanism.joints.size() == 1) { featured_joint_ = 0; }
    const System* last = nullptr;
    for (const Step& step : steps_) {
        if (step.kind != Step::Kind::motion) { continue; }
        if (last != nullptr && last != step.system.get()) {
            for (std::size_t k = 0; k < last->constraints().size(); ++k) {
                const Constraint& now = step.system->constraints()[k];
                if (now.dropped == last->constraints()[k].dropped) { continue; }
                featured_joint_ = now.joint;
                return;
            }
        }
        last = step.system.get();
    }
}

void Story::tell_bodies() {
    system_ = std::make_shared<System>(lesson_->mechanism, Selection{});
    Step step;
    step.kind = Step::Kind::bodies;
    step.system = system_;
    step.t = start_time_;
    step.state = state_;
    step.velocity = start_motion(lesson_->mechanism);
    step.acceleration = zero_motion(lesson_->mechanism);
    rank_ = present_rank();
    step.rank = rank_;
    steps_.push_back(std::move(step));
}

/// True if a joint or driver asks for nothing that the present pose does not do.
bool Story::fits_as_it_is(const Addition& added) const {
    if (added.kind == Addition::Kind::driver) {
        const Driver& driver = lesson_->mechanism.drivers[at(added.index)];
        const System alone(lesson_->mechanism, {{}, {added.index}});
        const DriverConstraint& c = alone.drivers().front();
        const Motion none = zero_motion(lesson_->mechanism);
        const double value =
            evaluate_measure(driver.measure, driver.body_i, driver.body_j, c.theta, state_, none, none).value;
        const double target = target_of(driver.measure, driver.function, start_time_).f;
        return std::abs(driver_residual(driver.measure, value, target)) <=
               residual_tolerance(alone, state_) * c.unit;
    }
    System alone(lesson_->mechanism, {{added.index}, {}});
    alone.choose_rows(state_);
    const double tolerance = residual_tolerance(alone, state_);
    for (const Constraint& c : alone.constraints()) {
        const VectorX values = values_of(c, state_);
        for (int k = 0; k < c.equations; ++k) {
            if (c.has_row(k) && !(std::abs(values(k)) <= tolerance * c.unit)) { return false; }
        }
    }
    return is_meant(alone, state_, intended_sides(alone));
}

/// The steps of a joint or driver that fits as it is, without the system of all that are there by then: what
/// was solved before is not looked at again.
/// @return false, and nothing told, where something has to move
bool Story::tell_quietly(int count) {
    const Addition& added = lesson_->order[at(count - 1)];
    if (!is_exact_ || system_->columns(3) <= kMostDenseColumns || !fits_as_it_is(added)) { return false; }
    Step step;
    step.additions = count;
    step.kind = Step::Kind::equations;
    steps_.push_back(step);
    step.kind = Step::Kind::assembled;
    steps_.push_back(std::move(step));
    return true;
}

void Story::forget_poses() {
    for (; forgotten_ + 1 < steps_.size(); ++forgotten_) {
        Step light;
        light.kind = steps_[forgotten_].kind;
        light.additions = steps_[forgotten_].additions;
        steps_[forgotten_] = std::move(light);
    }
}

bool Story::tell_addition(int count) {
    const Addition& added = lesson_->order[static_cast<std::size_t>(count - 1)];
    ask(Question::Place::addition, &added, Step::Kind::question);
    if (!close_addition(count)) { return false; }
    ask(Question::Place::addition, &added, Step::Kind::answer);
    return true;
}

bool Story::close_addition(int count) {
    auto system = std::make_shared<System>(lesson_->mechanism, selection_of(*lesson_, count));
    system->inherit_rows(*system_);
    const std::shared_ptr<const System> before = system_;
    system->choose_rows(state_);
    system_ = system;

    Step step;
    step.t = start_time_;
    step.velocity = start_motion(lesson_->mechanism);
    step.acceleration = zero_motion(lesson_->mechanism);
    step.kind = Step::Kind::equations;
    step.additions = count;
    step.system = system_;
    step.state = state_;
    step.rank_before = rank_;
    step.rank = nullptr;
    const Addition& added = lesson_->order[static_cast<std::size_t>(count - 1)];
    for (std::size_t k = 0; added.kind == Addition::Kind::joint && k < system->constraints().size(); ++k) {
        const Constraint& c = system->constraints()[k];
        if (c.joint == added.index && is_parallel(c.role)) {
            step.choices.push_back(explain_choice(*system, static_cast<int>(k), state_, -1));
        }
    }
    steps_.push_back(step);

    // each iteration a step of its own
    step.kind = Step::Kind::iteration;
    const PositionObserver observer = [&](const PositionEvent& event, const State& state) {
        step.events.push_back(event);
        const auto* newton = std::get_if<NewtonStep>(&event);
        if (newton != nullptr && newton->rank == 0) { return; }  // the last look: closed, or given up
        step.state = state;
        steps_.push_back(step);
    };
    const PositionOutcome outcome = with_choice(lesson_->coordinates, [&](auto choice) {
        return solve_position<decltype(choice)>(*system_, state_, start_time_, observer);
    });

    step.state = state_;
    is_exact_ = outcome.ok() && outcome.newton.residual <= residual_tolerance(*system_, state_);
    if (!outcome.ok()) {
        thin_out_iterations(steps_);
        step.kind = Step::Kind::failed;
        step.failure = outcome.failure;
        step.rank = present_rank();
        steps_.push_back(std::move(step));
        return false;
    }
    // the choice of rows never changes inside a solve; a new one is made at the solution
    auto settled = std::make_shared<System>(*system_);
    if (settled->choose_rows(state_)) { system_ = settled; }
    step.kind = Step::Kind::assembled;
    step.system = system_;
    rank_ = present_rank();
    step.rank = rank_;
    steps_.push_back(std::move(step));
    return true;
}

void Story::tell_motion(const MotionPlan& plan, const StoryOptions& options) {
    System system = *system_;
    MotionTracker tracker(system, state_, start_time_);
    std::shared_ptr<const System> shared = system_;
    const int intervals = options.intervals > 0 ? options.intervals : plan.steps;
    for (int k = 0; k <= intervals; ++k) {
        const double t = plan.from + (plan.to - plan.from) * k / intervals;
        bool switched = false;
        const bool ok = k == 0 || advance_along(tracker, *lesson_, t, switched);
        const MotionFrame& frame = tracker.frame();
        if (switched) { shared = std::make_shared<System>(system); }
        Step step;
        step.kind = Step::Kind::motion;
        step.additions = static_cast<int>(lesson_->order.size());
        step.system = shared;
        step.t = frame.t;
        step.state = frame.state;
        step.velocity = frame.velocity;
        step.acceleration = frame.acceleration;
        step.rows_switched = switched;
        step.change_point = frame.change_point;
        step.velocity_verdict = frame.velocity_verdict;
        step.acceleration_verdict = frame.acceleration_verdict;
        if (!ok) { step.failure = tracker.failure(); }
        steps_.push_back(std::move(step));
        if (!ok) { return; }
        if (options.progress) { options.progress(static_cast<double>(k) / intervals); }
    }
}

/// Tells the motion by masses and forces from the assembled pose on, by the lesson's method.
void Story::tell_dynamics(const MotionPlan& plan, const StoryOptions& options) {
    const Mechanism assembled = placed_at(lesson_->mechanism, state_);
    const int intervals = options.intervals > 0 ? options.intervals : plan.steps;
    DynamicsRequest request = request_of(*lesson_);
    request.settings.most_steps = kMostStepsOfStory;
    Simulation simulation(assembled, lesson_->dynamics->loads, request.settings);
    const int between = moments_between(options, intervals, assembled);
    const std::vector<double> times = equal_times(plan.to, intervals * between);
    auto centroidal = std::make_shared<const Centroidal>(simulation.scene());
    const bool counts_turns = !centroidal->loads.rotational_springs.empty();
    System system = *system_;
    std::shared_ptr<const System> shared = system_;
    int moment = 0;
    bool switched = false;
    const SimulationOutcome outcome = simulation.run(times, [&](double t, const std::vector<double>& y) {
        const Snapshot snapshot = simulation.snapshot(t, y);
        Step step;
        if (t == 0.0) { step.note = start_note(assembled, snapshot); }
        step.kind = Step::Kind::motion;
        step.additions = static_cast<int>(lesson_->order.size());
        const bool switched_now = system.choose_rows(snapshot.state);
        if (switched_now) { shared = std::make_shared<System>(system); }
        switched = switched || switched_now;
        step.rows_switched = switched_now;
        step.system = shared;
        step.t = t;
        step.state = snapshot.state;
        step.velocity = snapshot.velocity;
        step.centroidal_acceleration = simulation.acceleration(t, y);
        step.acceleration = simulation.acceleration_as_given(y, step.centroidal_acceleration);
        step.velocity_verdict.unique = step.acceleration_verdict.unique = true;
        // springs that have been wound up know their turns from the run alone
        if (counts_turns) { centroidal = std::make_shared<const Centroidal>(simulation.scene()); }
        step.centroidal = centroidal;
        step.energy = Energy{snapshot.kinetic, snapshot.potential};
        if (between > 1) { curve_.push_back(step); }
        if (moment++ % between != 0) { return; }
        step.rows_switched = switched;
        switched = false;
        steps_.push_back(std::move(step));
        if (options.progress) { options.progress(t / plan.to); }
    });
    if (!outcome.failure) { return; }
    if (steps_.back().kind != Step::Kind::motion) {
        Step& start = steps_.emplace_back();
        start.kind = Step::Kind::motion;
        start.additions = static_cast<int>(lesson_->order.size());
        start.system = shared;
        start.state = state_;
        start.velocity = start_motion(assembled);
        start.acceleration = zero_motion(assembled);
    }
    // where it ends between two steps, the last moment is the one to be shown
    if (!curve_.empty() && curve_.back().t > steps_.back().t) { steps_.push_back(curve_.back()); }
    steps_.back().ended = failure_text(*outcome.failure, request.settings, lesson_->mechanism);
}

}  // namespace jw
