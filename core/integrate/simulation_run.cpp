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
    : simulation_(&simulation), watch_(std::move(watch)), end_(times.empty() ? 0.0 : times.back()) {
    outcome_.failure = simulation.contradiction_;
    if (outcome_.failure) { return; }
    if (simulation.counts_turns()) {
        begin_turns(simulation.scene_.loads, kinematics_of(simulation.unpacked(simulation.start_).first));
    }
    simulation.count_turns_at(simulation.start_);
    stepper_ = simulation.stepper(end_);
    sampler_ = std::make_unique<Sampler>(
        simulation.integrated(), times, std::move(receive), simulation.tolerance_of_samples());
    sampler_->take(*stepper_);
    const SimulationSettings& settings = simulation.settings_;
    // checking all joints would cost more than an evaluation in joint coordinates: a quarter of them per step
    const bool in_joints = simulation.other_ && !settings.dense;
    const int shares = in_joints ? 4 : 1;
    certificate_ = std::make_unique<Certificate>(simulation.scene_, simulation.stabilisation(), shares);
    // all of them at the start: a contradictory scene is not started
    for (int share = 0; share < shares && !outcome_.failure; ++share) {
        outcome_.failure = simulation.failure_of_proof(*certificate_, *stepper_, outcome_.residual);
    }
    // fixed steps do not stop at events
    const bool adaptive = entry_of(settings.method).adaptive;
    events_ = adaptive ? events_until(end_, simulation.scene_) : std::vector{end_};
    std::ranges::reverse(events_);
}

SimulationRun::~SimulationRun() = default;

bool SimulationRun::goes_on() const {
    return stepper_->t() < events_.back() && !outcome_.failure && !sampler_->ended();
}

bool SimulationRun::step() {
    while (!events_.empty() && !goes_on()) {
        sampler_->begin_anew();
        events_.pop_back();
    }
    if (events_.empty()) { return false; }
    outcome_.failure = simulation_->failure_of_step(*stepper_, events_.back(), end_);
    if (!outcome_.failure) {
        outcome_.failure = simulation_->failure_of_proof(*certificate_, *stepper_, outcome_.residual);
    }
    const long steps = stepper_->counts().steps;
    if (watch_ && !outcome_.failure && steps % kStepsBetweenLooks == 0 && stepper_->t() < end_ &&
        !watch_({stepper_->t(), end_, steps, stepper_->bound_by_stability()})) {
        outcome_.failure = simulation_->too_many_steps(*stepper_);
    }
    if (!outcome_.failure || outcome_.failure->cause == SimulationFailure::Cause::too_many_steps) {
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
    outcome_.counts = stepper_->counts();
    return outcome_;
}

}  // namespace jw
