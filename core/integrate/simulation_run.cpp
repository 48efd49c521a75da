#include <algorithm>
#include <utility>

#include "core/integrate/simulation.hpp"
#include "core/integrate/time_stepper.hpp"
#include "core/motion/certificate.hpp"
#include "core/motion/time_events.hpp"

namespace jw {

SimulationOutcome Simulation::run(
    const std::vector<double>& times, const Sampler::Receive& receive, const RunWatch& watch) {
    SimulationRun run(*this, times, receive, watch);
    while (run.step()) {}
    return run.finish();
}

SimulationRun::SimulationRun(
    Simulation& simulation, const std::vector<double>& times, Sampler::Receive receive, RunWatch watch)
    : simulation_(&simulation),
      watch_(std::move(watch)),
      times_(times),
      receive_(std::move(receive)),
      end_(times.empty() ? 0.0 : times.back()) {
    outcome_.failure = simulation.contradiction_;
    if (outcome_.failure) { return; }
    if (simulation.counts_turns()) {
        begin_turns(simulation.scene_.loads, kinematics_of(simulation.unpacked(simulation.start_).first));
    }
    simulation.count_turns_at(simulation.start_);
    begin(0.0, simulation.integrated_start());
    if (simulation.counts_turns() && !outcome_.failure) {
        outcome_.failure = simulation.failure_of_turns(0.0, simulation.start_);
    }
    // fixed steps do not stop at events
    const bool adaptive = entry_of(simulation.settings_.method).adaptive;
    events_ = adaptive ? events_until(end_, simulation.scene_) : std::vector{TimeEvent{end_, true}};
    std::ranges::reverse(events_);
}

SimulationRun::~SimulationRun() = default;

/// Begins at a state in the coordinates that are integrated, and gives out its sample.
void SimulationRun::begin(double t, std::vector<double> start) {
    Simulation& simulation = *simulation_;
    stepper_ = simulation.stepper(t, std::move(start), end_);
    simulation.follow_angles_to(*stepper_);
    sampler_ = std::make_unique<Sampler>(
        simulation.integrated(), times_, receive_, simulation.tolerance_of_samples());
    sampler_->take(*stepper_);
    // checking all joints would cost more than an evaluation in joint coordinates: a quarter is checked per
    // step
    const bool in_joints = simulation.other_ && !simulation.settings_.dense;
    const int shares = in_joints ? 4 : 1;
    certificate_ = std::make_unique<Certificate>(simulation.scene_, simulation.stabilisation(), shares);
    // all of them at the start: a contradictory scene does not start
    for (int share = 0; share < shares && !outcome_.failure; ++share) {
        outcome_.failure = simulation.failure_of_proof(*certificate_, *stepper_, outcome_.residual);
    }
    remember();
}

void SimulationRun::remember() {
    proved_until_ = stepper_->t();
    if (simulation_->other_) { proved_ = stepper_->y(); }
}

/// Continues from the last state that was proved, in coordinates of the bodies.
bool SimulationRun::go_on_with_bodies() {
    Simulation& simulation = *simulation_;
    if (!simulation.may_leave_joints()) { return false; }
    std::vector<double> start = simulation.flat_of(proved_);
    sampler_->finish();
    if (sampler_->ended()) { return false; }
    simulation.other_.reset();
    counts_in_joints_ = stepper_->counts();
    outcome_.bodies_from = proved_until_;
    outcome_.failure.reset();
    std::erase_if(times_, [&](double t) { return t <= proved_until_; });
    begin(proved_until_, std::move(start));
    return true;
}

bool SimulationRun::goes_on() const {
    return stepper_->t() < events_.back().t && !outcome_.failure && !sampler_->ended();
}

bool SimulationRun::step() {
    while (!events_.empty() && !goes_on()) {
        if (events_.back().jumps) { sampler_->begin_anew(); }
        events_.pop_back();
    }
    if (events_.empty()) { return false; }
    const AccelerationResidual proved = outcome_.residual;
    outcome_.failure = simulation_->failure_of_step(*stepper_, events_.back().t, end_);
    if (!outcome_.failure) {
        outcome_.failure = simulation_->failure_of_proof(*certificate_, *stepper_, outcome_.residual);
    }
    if (outcome_.failure && outcome_.failure->cause == SimulationFailure::Cause::not_proven) {
        const AccelerationResidual not_proved = std::exchange(outcome_.residual, proved);
        if (go_on_with_bodies()) { return true; }
        outcome_.residual = not_proved;
    }
    const long steps = stepper_->counts().steps;
    if (watch_ && !outcome_.failure && steps % kStepsBetweenLooks == 0 && stepper_->t() < end_ &&
        !watch_({stepper_->t(), end_, steps, stepper_->bound_by_stability()})) {
        outcome_.failure = simulation_->too_many_steps(*stepper_);
    }
    if (!outcome_.failure || outcome_.failure->cause == SimulationFailure::Cause::too_many_steps) {
        simulation_->follow_angles_to(*stepper_);
        remember();
        sampler_->take(*stepper_);
    }
    return true;
}

SimulationOutcome SimulationRun::finish() {
    if (!stepper_) { return outcome_; }
    sampler_->finish();
    if (sampler_->ended()) {
        outcome_.failure =
            SimulationFailure{SimulationFailure::Cause::step_too_small, *sampler_->ended(), {}, 0.0};
    }
    outcome_.counts = counts_in_joints_;
    outcome_.counts += stepper_->counts();
    return outcome_;
}

}  // namespace jw
