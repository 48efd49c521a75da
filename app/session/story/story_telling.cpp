#include "app/session/story/story_telling.hpp"

#include <algorithm>
#include <cmath>

#include "app/session/story/motion_telling.hpp"
#include "core/kinematics/motion_tracker.hpp"
#include "core/poses/branches.hpp"
#include "core/poses/large_rank.hpp"

namespace jw {

namespace {

// iterations shown of a solve that fails: the beginning is worth showing, sixty more of the same are not
constexpr std::size_t kFirstIterations = 6;

/// Keeps the first iterations of the last solve, and its last one; the Newton table has all of them.
void thin_out_iterations(std::vector<Step>& steps) {
    std::size_t first = steps.size();
    while (first > 0 && steps[first - 1].kind == Step::Kind::iteration) { --first; }
    if (steps.size() - first <= kFirstIterations + 1) { return; }
    steps.erase(
        steps.begin() + static_cast<std::ptrdiff_t>(first + kFirstIterations), std::prev(steps.end()));
}

/// The lesson's prescribed motion.
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

StoryTelling::StoryTelling(const Lesson& lesson, const StoryOptions& options)
    : lesson_(&lesson), options_(options), start_time_(options.start_time.value_or(start_time(lesson))) {
    const auto all = static_cast<int>(lesson.order.size());
    additions_ = options.additions < 0 ? all : std::min(options.additions, all);
    state_ = start_state(lesson.mechanism);
    tell_bodies();
    ask(Question::Place::bodies, nullptr, Step::Kind::question);
    ask(Question::Place::bodies, nullptr, Step::Kind::answer);
}

StoryTelling::~StoryTelling() = default;

bool StoryTelling::is_enough() const {
    return options_.last_step >= 0 && options_.last_step < static_cast<int>(told_->steps.size());
}

bool StoryTelling::end() {
    ended_ = true;
    motion_.reset();
    return false;
}

bool StoryTelling::go_on() {
    if (ended_) { return false; }
    work_ += motion_ ? motion_->work_of_piece() : static_cast<double>(lesson_->mechanism.bodies.size());
    if (motion_) {
        if (motion_->go_on(told_->steps, told_->curve)) { return true; }
        if (!told_->steps.back().failed()) { ask(Question::Place::motion, nullptr, Step::Kind::answer); }
    } else {
        if (is_enough()) { return end(); }
        if (added_ < additions_) {
            const int count = ++added_;
            const bool quiet = !options_.keep_steps && count < additions_ && tell_quietly(count);
            if (!quiet && !tell_addition(count)) { return end(); }
            if (!options_.keep_steps) { forget_poses(); }
            return true;
        }
        if (begin_motion()) { return true; }
    }
    find_featured_joint();
    return end();
}

std::optional<MotionPlan> StoryTelling::motion_to_tell() const {
    const bool all = additions_ == static_cast<int>(lesson_->order.size());
    return options_.with_motion && all ? shown_motion(*lesson_) : std::nullopt;
}

bool StoryTelling::begin_motion() {
    const std::optional<MotionPlan> plan = motion_to_tell();
    if (!plan) { return false; }
    ask(Question::Place::motion, nullptr, Step::Kind::question);
    const Assembled from{*lesson_, system_, state_};
    if (lesson_->motion) {
        motion_ = std::make_unique<PrescribedMotion>(from, *plan, options_);
    } else {
        motion_ = tell_motion_by_forces(from, *plan, options_);
    }
    return true;
}

double StoryTelling::progress() const {
    if (ended_) { return 1.0; }
    const std::optional<MotionPlan> plan = motion_to_tell();
    // a moment of the motion takes about as long as a joint
    const double moments = plan ? plan->steps : 0;
    const double moved = motion_ ? motion_->progress() : 0.0;
    return (added_ + moved * moments) / std::max(1.0, additions_ + moments);
}

void StoryTelling::find_featured_joint() {
    if (lesson_->mechanism.joints.size() == 1) { told_->featured_joint = 0; }
    const System* last = nullptr;
    for (const Step& step : told_->steps) {
        if (step.kind != Step::Kind::motion) { continue; }
        if (last != nullptr && last != step.system.get()) {
            for (std::size_t k = 0; k < last->constraints().size(); ++k) {
                const Constraint& now = step.system->constraints()[k];
                if (now.dropped == last->constraints()[k].dropped) { continue; }
                told_->featured_joint = now.joint;
                return;
            }
        }
        last = step.system.get();
    }
}

void StoryTelling::tell_bodies() {
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
    told_->steps.push_back(std::move(step));
}

/// True if the present pose already satisfies everything that a joint or driver asks for.
bool StoryTelling::fits_as_it_is(const Addition& added) const {
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

/// Tells the steps of a joint or driver that fits as it is, without building the system of everything added
/// so far: what was solved before is not checked again.
/// @return false, with nothing told, if something has to move
bool StoryTelling::tell_quietly(int count) {
    const Addition& added = lesson_->order[at(count - 1)];
    if (!is_exact_ || system_->columns(3) <= kMostDenseColumns || !fits_as_it_is(added)) { return false; }
    Step step;
    step.additions = count;
    step.kind = Step::Kind::equations;
    told_->steps.push_back(step);
    step.kind = Step::Kind::assembled;
    told_->steps.push_back(std::move(step));
    return true;
}

void StoryTelling::forget_poses() {
    for (; forgotten_ + 1 < told_->steps.size(); ++forgotten_) {
        Step light;
        light.kind = told_->steps[forgotten_].kind;
        light.additions = told_->steps[forgotten_].additions;
        told_->steps[forgotten_] = std::move(light);
    }
}

bool StoryTelling::tell_addition(int count) {
    const Addition& added = lesson_->order[at(count - 1)];
    ask(Question::Place::addition, &added, Step::Kind::question);
    if (!close_addition(count)) { return false; }
    ask(Question::Place::addition, &added, Step::Kind::answer);
    return true;
}

bool StoryTelling::close_addition(int count) {
    auto system = std::make_shared<System>(lesson_->mechanism, selection_of(*lesson_, count));
    system->inherit_rows(*system_);
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
    const Addition& added = lesson_->order[at(count - 1)];
    for (std::size_t k = 0; added.kind == Addition::Kind::joint && k < system->constraints().size(); ++k) {
        const Constraint& c = system->constraints()[k];
        if (c.joint == added.index && is_parallel(c.role)) {
            step.choices.push_back(explain_choice(*system, static_cast<int>(k), state_, -1));
        }
    }
    told_->steps.push_back(step);

    // each iteration is its own step
    step.kind = Step::Kind::iteration;
    const PositionObserver observer = [&](const PositionEvent& event, const State& state) {
        step.events.push_back(event);
        const auto* newton = std::get_if<NewtonStep>(&event);
        if (newton != nullptr && newton->rank == 0) { return; }  // the last check: closed, or given up
        step.state = state;
        told_->steps.push_back(step);
    };
    const PositionOutcome outcome = with_choice(lesson_->coordinates, [&](auto choice) {
        return solve_position<decltype(choice)>(*system_, state_, start_time_, observer);
    });

    step.state = state_;
    is_exact_ = outcome.ok() && outcome.newton.residual <= residual_tolerance(*system_, state_);
    if (!outcome.ok()) {
        thin_out_iterations(told_->steps);
        step.kind = Step::Kind::failed;
        step.failure = outcome.failure;
        step.rank = present_rank();
        told_->steps.push_back(std::move(step));
        return false;
    }
    // the choice of rows never changes inside a solve; a new one is made at the solution
    auto settled = std::make_shared<System>(*system_);
    if (settled->choose_rows(state_)) { system_ = settled; }
    step.kind = Step::Kind::assembled;
    step.system = system_;
    rank_ = present_rank();
    step.rank = rank_;
    told_->steps.push_back(std::move(step));
    return true;
}

/// Adds the questions (or the answers) that belong to `place`, at the pose of the last step.
void StoryTelling::ask(Question::Place place, const Addition* added, Step::Kind kind) {
    // a story of poses alone has no questions
    if (!options_.keep_steps) { return; }
    for (std::size_t k = 0; k < lesson_->questions.size(); ++k) {
        const Question& question = lesson_->questions[k];
        const bool here = question.place == place && (added == nullptr || question.addition == *added);
        if (!here || !applies(question, *lesson_)) { continue; }
        Step step = told_->steps.back();
        step.kind = kind;
        step.question = static_cast<int>(k);
        step.choices.clear();
        step.events.clear();
        step.note.clear();
        step.rows_switched = step.change_point = false;
        step.rank_before = nullptr;
        told_->steps.push_back(std::move(step));
    }
}

RankWhenAsked StoryTelling::present_rank() const {
    if (!options_.with_ranks) { return nullptr; }
    return RankWhenAsked(
        [system = system_, state = state_, t = start_time_] { return rank_of(*system, state, t); });
}

ToldLesson tell_at_once(std::shared_ptr<const Lesson> lesson, const StoryOptions& options) {
    Story story(*lesson, options);
    return {std::move(lesson), std::move(story)};
}

}  // namespace jw
