#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/integrate/sampler.hpp"
#include "core/integrate/simulation_settings.hpp"
#include "core/kinematics/joint_angles.hpp"
#include "core/motion/forces.hpp"
#include "core/motion/time_events.hpp"

/// Simulation of a mechanism under its loads from t = 0 on, by any of the methods.
namespace jw {

class Certificate;
class TreeEquations;

/// State of the mechanism at one moment, in the frames as given.
struct Snapshot {
    double t = 0.0;
    State state;
    Motion velocity;
    double kinetic = 0.0;             ///< kinetic energy [J]
    double potential = 0.0;           ///< potential energy of gravity and springs [J]
    double position_violation = 0.0;  ///< largest |Φ|, divided by the size of its equation
    double velocity_violation = 0.0;  ///< largest |Φq q̇ - ν| likewise [1/s]
    double p_drift = 0.0;             ///< largest ||p| - 1|
    std::vector<int> turns;           ///< turns of every joint; empty unless followed, see follow_angles
};

/// Reason why a simulation ended early.
struct SimulationFailure {
    enum class Cause {
        contradiction,  ///< redundant equations contradict the others
        out_of_reach,   ///< no state satisfies the equations
        not_proven,     ///< accelerations do not satisfy the equations of motion
        step_too_small,
        not_finite,
        turns_lost,  ///< a fixed step turns a rotational spring too far for its turns to be counted
        too_many_steps
    };
    Cause cause = Cause::step_too_small;
    double t = 0.0;
    /// For the first three causes: the joint or driver with the largest residual; empty if the forces have
    /// the largest one. For turns_lost: the joint of the spring.
    std::string equation_of;
    double violation = 0.0;  ///< for the first three causes: the residual divided by the size of the equation
    double turn = 0.0;       ///< for turns_lost: by how much the spring turns within the step [rad]
    bool of_accelerations = false;  ///< `violation` is that of the accelerations
    /// For too_many_steps: stability bounded the steps, not accuracy; an implicit method takes longer ones.
    bool bound_by_stability = false;
    std::string fastest = {};   ///< for too_many_steps: the body that turned fastest
    double fastest_rate = 0.0;  ///< its |ω| [rad/s]
    std::string law = {};       ///< of a load that has no value or no slope at the end
};

/// Progress of a run.
struct RunState {
    double t = 0.0;    ///< [s]
    double end = 0.0;  ///< [s]
    long steps = 0;
    double bound_by_stability = 0.0;  ///< see TimeStepper
};
/// Callback for the progress of a run. @return false to give up: the run ends with too_many_steps
using RunWatch = std::function<bool(const RunState&)>;
/// Number of steps between two calls of a RunWatch.
inline constexpr long kStepsBetweenLooks = 200;

/// Result of a run: its cost, its failure if it ended early, and the proof of its accelerations.
struct SimulationOutcome {
    IntegrationCounts counts;
    std::optional<SimulationFailure> failure;
    /// Largest residuals of the accelerations in the equations of motion over all steps.
    AccelerationResidual residual;
    /// Time at which a run in joint coordinates continued in coordinates of the bodies, because its
    /// accelerations could no longer be proved [s].
    std::optional<double> bodies_from;
};

/// Simulation of one mechanism from its start pose on.
class Simulation {
public:
    /// @throws std::invalid_argument if a moving body has no mass, or a setting is not positive
    Simulation(const Mechanism& mechanism, const Loads& loads, const SimulationSettings& settings);
    /// Not copyable: the equations refer to the simulation's own scene.
    ~Simulation();
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;

    /// Integrates from the start to the last of `times` (ascending, from 0 on) and passes the state at every
    /// time to `receive`, in order. Passes no state if the equations contradict each other at the start.
    /// @param watch called every kStepsBetweenLooks steps
    [[nodiscard]] SimulationOutcome run(
        const std::vector<double>& times, const Sampler::Receive& receive, const RunWatch& watch = {});

    /// Follows the angles of joints from the next run on, for its snapshots.
    void follow_angles() { angles_ = std::make_unique<FollowedAngles>(scene_.mechanism); }
    /// State, energies and violations at time t [s].
    /// @param y flat state, as passed to `receive`
    Snapshot snapshot(double t, const std::vector<double>& y) const;
    /// Kinetic and potential energy (gravity and springs) at y [J].
    Energy energy(const std::vector<double>& y) const;
    /// Position of a point of a body, global; `point_local` in the frame as given [m].
    Vec3 point(const std::vector<double>& y, int body, const Vec3& point_local) const;
    /// Velocity of that point, global [m/s].
    Vec3 point_velocity(const std::vector<double>& y, int body, const Vec3& point_local) const;
    /// Accelerations r̈, ω̇' of the centroidal frames.
    Motion acceleration(double t, const std::vector<double>& y);
    /// Accelerations r̈, ω̇' of the frames as given.
    Motion acceleration_as_given(double t, const std::vector<double>& y);
    /// The same from the accelerations of the centroidal frames at `y`, where they are known.
    Motion acceleration_as_given(const std::vector<double>& y, const Motion& centroidal) const;
    const Centroidal& scene() const { return scene_; }
    /// Block-sparse equations, in flat states, independent of the coordinates that are integrated.
    MotionEquations& equations() const { return *block_; }
    /// Equations that are integrated, and their start.
    MotionEquations& integrated() const { return other_ ? *other_ : *block_; }
    std::vector<double> integrated_start() const;

private:
    friend class SimulationRun;

    std::unique_ptr<TimeStepper> stepper(double t, std::vector<double> start, double end) const;
    Baumgarte stabilisation() const;
    void take_joints();
    bool keeps_digits(TreeEquations& tree);  ///< compared with the block equations
    void take_up_rows(double t, const std::vector<double>& y, std::vector<double>& y_dot);
    bool is_proven(double t, const std::vector<double>& y, const std::vector<double>& y_dot);
    bool counts_turns() const;
    /// Counts the turns of rotational springs at a flat state that the motion has reached.
    void count_turns_at(const std::vector<double>& y);
    /// Failure if a fixed step from a flat state would lose turns of rotational springs; otherwise none.
    std::optional<SimulationFailure> failure_of_turns(double t, const std::vector<double>& y) const;
    /// Follows the angles of joints to the state of the stepper, if they were requested.
    void follow_angles_to(const TimeStepper& stepper);
    /// True if joint coordinates are integrated that were not requested.
    bool may_leave_joints() const;
    void look_for_contradiction(const std::vector<double>& as_given);
    void look_for_contradicting_rates();
    /// Flat state of the numbers that are integrated.
    std::vector<double> flat_of(const std::vector<double>& y) const;
    /// Substitutes the accelerations at the end of a step into the equations of motion.
    std::optional<SimulationFailure> failure_of_proof(
        Certificate& certificate, const TimeStepper& stepper, AccelerationResidual& worst) const;
    double tolerance_of_samples() const;
    /// Takes one step towards `event`. @return why the run cannot continue, if it cannot
    std::optional<SimulationFailure> failure_of_step(TimeStepper& stepper, double event, double end);
    SimulationFailure too_many_steps(const TimeStepper& stepper) const;
    /// Reason why the stepper can take no further step.
    SimulationFailure failure_of(const TimeStepper& stepper) const;
    std::string law_at_end(const TimeStepper& stepper) const;
    /// Failure of a cause that names the equation with the largest Φ, or Φ̇, at a flat state.
    enum class Off { value, rate };
    SimulationFailure worst_equation(
        SimulationFailure::Cause cause, Off off, double t, const std::vector<double>& y) const;
    /// State and motion of the centroidal frames.
    std::pair<State, Motion> unpacked(const std::vector<double>& y) const;

    Centroidal scene_;
    SimulationSettings settings_;
    std::vector<int> moving_;
    std::vector<int> order_of_body_;
    std::unique_ptr<DrivableEquations> block_;
    std::unique_ptr<MotionEquations> other_;  ///< equations that are integrated, if not `block_`
    std::vector<double> start_;               ///< flat state at the start
    std::optional<SimulationFailure> contradiction_;
    std::unique_ptr<Certificate>
        certificate_;  ///< of accelerations between the steps; made when they are requested
    std::unique_ptr<FollowedAngles> angles_;  ///< if they are followed
};

/// A run of a simulation, step by step, for callers that do other things in between.
class SimulationRun {
public:
    /// Passes the state at the first of `times` (see Simulation::run), and takes no step. `simulation` must
    /// outlive this.
    SimulationRun(
        Simulation& simulation, const std::vector<double>& times, Sampler::Receive receive,
        RunWatch watch = {});
    ~SimulationRun();
    SimulationRun(const SimulationRun&) = delete;
    SimulationRun& operator=(const SimulationRun&) = delete;

    /// Takes a step. @return false if the run has ended
    bool step();
    /// Result of the run, once it has ended.
    SimulationOutcome finish();
    /// See SimulationOutcome.
    std::optional<double> bodies_from() const { return outcome_.bodies_from; }

private:
    bool goes_on() const;
    void begin(double t, std::vector<double> start);
    bool go_on_with_bodies();
    void remember();

    Simulation* simulation_;
    RunWatch watch_;
    std::vector<double> times_;  ///< [s]
    Sampler::Receive receive_;
    double end_ = 0.0;                    ///< [s]
    double proved_until_ = 0.0;           ///< [s]
    std::vector<double> proved_;          ///< state at that time, in coordinates of the joints; else unused
    IntegrationCounts counts_in_joints_;  ///< counts of the part in joint coordinates
    std::vector<TimeEvent> events_;       ///< times ahead at which steps end, the next one last
    std::unique_ptr<TimeStepper> stepper_;
    std::unique_ptr<Sampler> sampler_;
    std::unique_ptr<Certificate> certificate_;
    SimulationOutcome outcome_;
};

}  // namespace jw
