#include "app/session/benchmark/kinematics_bench.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "app/session/story/story.hpp"
#include "core/kinematics/motion_tracker.hpp"
#include "lessons/lesson/enum_words.hpp"

namespace jw {

namespace {

constexpr int kFramesOfBench = 200;
constexpr int kRepeats = 5;

struct BenchInstant {
    double t = 0.0;
    State state;
    Motion velocity;
    Motion acceleration;
};

class Stopwatch {
public:
    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    }

private:
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// The frame after one more Newton step: near singular poses, Newton's tolerance costs digits.
BenchInstant corrected(Kinematics<OmegaLocal>& kinematics, const MotionFrame& frame) {
    kinematics.set_state(frame.state, frame.t);
    const State state = frame.change_point ? frame.state : kinematics.corrected_state();
    kinematics.set_state(state, frame.t);
    const Motion velocity = kinematics.solve_velocity(frame.velocity).velocity;
    return {frame.t, state, velocity, kinematics.solve_acceleration(velocity).acceleration};
}

/// The motion at equal intervals; empty if it cannot be followed.
std::vector<BenchInstant> moments_of(System system, const State& start, const MotionPlan& plan) {
    MotionTracker tracker(system, start, plan.from);
    Kinematics<OmegaLocal> kinematics(system);
    std::vector<BenchInstant> moments;
    for (int k = 0; k <= kFramesOfBench; ++k) {
        const double t = plan.from + (plan.to - plan.from) * k / kFramesOfBench;
        if (!tracker.advance_to(t)) { return {}; }
        moments.push_back(corrected(kinematics, tracker.frame()));
    }
    return moments;
}

double size_of(const System& system, const Motion& motion) {
    double largest = 0.0;
    for (const int body : system.moving_bodies()) {
        const auto b = static_cast<std::size_t>(body);
        largest =
            std::max({largest, motion.r_dot[b].norm() / system.length_unit(), motion.omega_local[b].norm()});
    }
    return largest;
}

double difference(const System& system, const Motion& a, const Motion& b) {
    Motion rest = a;
    for (std::size_t k = 0; k < rest.r_dot.size(); ++k) {
        rest.r_dot[k] -= b.r_dot[k];
        rest.omega_local[k] -= b.omega_local[k];
    }
    return size_of(system, rest);
}

/// Errors of moments against the reference, relative to the largest motion on the way.
class Errors {
public:
    Errors(const System& system, const std::vector<BenchInstant>& reference) : system_(&system) {
        for (const BenchInstant& moment : reference) {
            velocity_size_ = std::max(velocity_size_, size_of(system, moment.velocity));
            acceleration_size_ = std::max(acceleration_size_, size_of(system, moment.acceleration));
        }
    }
    void take(KinematicsRun& run, const BenchInstant& found, const BenchInstant& reference) const {
        const auto worst = [](double before, double now) { return std::max(before, now); };
        run.position = worst(run.position, movement(*system_, found.state, reference.state));
        run.velocity =
            worst(run.velocity, difference(*system_, found.velocity, reference.velocity) / velocity_size_);
        run.acceleration = worst(
            run.acceleration,
            difference(*system_, found.acceleration, reference.acceleration) / acceleration_size_);
    }

private:
    const System* system_;
    double velocity_size_ = 1e-300;
    double acceleration_size_ = 1e-300;
};

template <class C>
KinematicsRun dense(System system, const std::vector<BenchInstant>& moments) {
    NewtonStepper<C> newton(system);
    Kinematics<C> kinematics(system);
    const Errors errors(system, moments);
    const double count = kFramesOfBench;
    KinematicsRun run;
    run.coordinates = word_of(kChoices, C::kChoice);
    run.microseconds = std::numeric_limits<double>::infinity();
    for (int repeat = 0; repeat < kRepeats; ++repeat) {
        double seconds = 0.0;
        int iterations = 0;
        run.missed = 0;
        for (std::size_t k = 1; k < moments.size(); ++k) {
            const Stopwatch watch;
            system.choose_rows(moments[k - 1].state);
            newton.start(moments[k - 1].state, moments[k].t);
            const NewtonOutcome outcome = solve(newton);
            kinematics.set_state(newton.state(), moments[k].t);
            const VelocityOutcome velocity = kinematics.solve_velocity(moments[k].velocity);
            const AccelerationOutcome acceleration = kinematics.solve_acceleration(velocity.velocity);
            seconds += watch.seconds();
            iterations += outcome.iterations;
            run.missed += outcome.converged ? 0 : 1;
            errors.take(
                run, {moments[k].t, newton.state(), velocity.velocity, acceleration.acceleration},
                moments[k]);
        }
        run.microseconds = std::min(run.microseconds, 1e6 * seconds / count);
        run.iterations = iterations / count;
    }
    return run;
}

/// Kinematics as the program computes it along a motion, with all checks.
KinematicsRun by_graph(System system, const std::vector<BenchInstant>& moments) {
    const Errors errors(system, moments);
    KinematicsRun run;
    run.coordinates = "graph";
    run.rows = "n1 pair";
    run.iterations = std::numeric_limits<double>::quiet_NaN();
    run.microseconds = std::numeric_limits<double>::infinity();
    for (int repeat = 0; repeat < kRepeats; ++repeat) {
        MotionTracker tracker(system, moments.front().state, moments.front().t);
        double seconds = 0.0;
        run.missed = 0;
        for (std::size_t k = 1; k < moments.size(); ++k) {
            const Stopwatch watch;
            const bool found = tracker.advance_to(moments[k].t);
            seconds += watch.seconds();
            run.missed += found ? 0 : 1;
            const MotionFrame& frame = tracker.frame();
            errors.take(run, {frame.t, frame.state, frame.velocity, frame.acceleration}, moments[k]);
        }
        run.microseconds = std::min(run.microseconds, 1e6 * seconds / kFramesOfBench);
    }
    return run;
}

void add_dense_runs(
    const System& system, const std::vector<BenchInstant>& moments, const std::string& rows,
    std::vector<KinematicsRun>& runs) {
    for (KinematicsRun run :
         {dense<OmegaLocal>(system, moments), dense<OmegaGlobal>(system, moments),
          dense<TrueEulerParameters>(system, moments), dense<ModifiedEulerParameters>(system, moments)}) {
        run.rows = rows;
        runs.push_back(std::move(run));
    }
}

}  // namespace

std::optional<KinematicsScene> bench_kinematics(const Lesson& lesson, const std::string& name) {
    if (!lesson.motion || lesson.mechanism.drivers.empty()) { return std::nullopt; }
    const Story story(lesson, poses_only());
    if (story.failure() != nullptr) { return std::nullopt; }
    const Step& start = story.steps().back();
    const std::vector<BenchInstant> moments = moments_of(*start.system, start.state, *lesson.motion);
    if (moments.empty()) { return std::nullopt; }

    KinematicsScene scene{
        name,
        static_cast<int>(start.system->moving_bodies().size()),
        start.system->rows(),
        kFramesOfBench,
        {}};
    add_dense_runs(*start.system, moments, "selected", scene.runs);
    Mechanism paired = lesson.mechanism;
    for (Joint& joint : paired.joints) {
        if (joint.parallel_form == ParallelForm::rule) { joint.parallel_form = ParallelForm::pair; }
    }
    add_dense_runs(System(paired, start.system->selection()), moments, "n1 pair", scene.runs);
    scene.runs.push_back(by_graph(*start.system, moments));
    return scene;
}

}  // namespace jw
