#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/dynamics/methods.hpp"
#include "core/dynamics/sampler.hpp"
#include "core/dynamics/tolerances.hpp"

/// A mechanism under its loads from t = 0 on, by any of the methods.
namespace jw {

class Certificate;
class TreeEquations;

struct SimulationSettings {
    Method method = Method::explicit_8;
    Treatment treatment = Treatment::projection;
    double tolerance = 1e-6;  ///< of adaptive methods
    double step = 1e-3;       ///< of the others [s]
    long most_steps = kMostStepsTaken;
    double baumgarte = 20.0;  ///< α = β of Baumgarte's stabilisation [1/s]
    /// What is integrated; the semi-implicit method moves bodies.
    Formulation formulation = Formulation::automatic;
    /// Set: the dense equations of the slides in these coordinates instead.
    std::optional<CoordinateChoice> dense;
};

/// The mechanism at one moment, in the frames of its author.
struct Snapshot {
    double t = 0.0;
    State state;
    Motion velocity;
    double kinetic = 0.0;             ///< energy [J]
    double potential = 0.0;           ///< of gravity and springs [J]
    double position_violation = 0.0;  ///< largest |Φ|, by the size of its equation
    double velocity_violation = 0.0;  ///< largest |Φq q̇ - ν| likewise [1/s]
    double p_drift = 0.0;             ///< largest ||p| - 1|
};

/// Why a simulation ended before its time.
struct SimulationFailure {
    enum class Cause {
        contradiction,  ///< equations that should repeat others ask for something else
        out_of_reach,   ///< nothing meets the equations
        not_proven,     ///< accelerations do not satisfy the equations of motion
        step_too_small,
        not_finite,
        too_many_steps
    };
    Cause cause = Cause::step_too_small;
    double t = 0.0;
    /// Of the first three: the joint or driver whose equation is off most; empty if it is that of the forces.
    std::string equation_of;
    double violation = 0.0;         ///< of the first three: by how much, by the size of the equation
    bool of_accelerations = false;  ///< `violation` is that of the accelerations
    /// Of too many steps: stability kept them short, not accuracy; an implicit method takes longer ones.
    bool bound_by_stability = false;
    std::string fastest = {};   ///< of too many steps: the body that turned fastest
    double fastest_rate = 0.0;  ///< its |ω| [rad/s]
};

/// How far a run is, for those who watch it.
struct RunState {
    double t = 0.0;    ///< [s]
    double end = 0.0;  ///< [s]
    long steps = 0;
    double bound_by_stability = 0.0;  ///< see TimeStepper
};
/// @return false to give up: the run ends as if it had taken too many steps
using RunWatch = std::function<bool(const RunState&)>;
/// Steps from one look to the next.
inline constexpr long kStepsBetweenLooks = 200;

struct SimulationOutcome {
    IntegrationCounts counts;
    std::optional<SimulationFailure> failure;
    /// Largest residuals of the accelerations in the equations of motion, over all steps.
    AccelerationResidual residual;
};

class Simulation {
public:
    /// @throws std::invalid_argument if a moving body has no mass, or a setting is not positive
    Simulation(const Mechanism& mechanism, const Loads& loads, const SimulationSettings& settings);
    /// What it integrates points into its own scene.
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;

    /// From the start to the last of `times` (ascending, from 0 on); every time is given to `receive` in
    /// order. None is where the equations contradict each other at the start.
    /// @param watch called now and then between steps
    [[nodiscard]] SimulationOutcome run(
        const std::vector<double>& times, const Sampler::Receive& receive, const RunWatch& watch = {});

    Snapshot snapshot(double t, const std::vector<double>& y) const;
    /// Position of a point of a body as given [m].
    Vec3 point(const std::vector<double>& y, int body, const Vec3& point_local) const;
    /// Velocity of it [m/s].
    Vec3 point_velocity(const std::vector<double>& y, int body, const Vec3& point_local) const;
    /// Accelerations r̈, ω̇' of the centroidal frames.
    Motion acceleration(double t, const std::vector<double>& y) const;
    /// The same of the frames of the author.
    Motion acceleration_as_given(double t, const std::vector<double>& y) const;
    const Centroidal& scene() const { return scene_; }
    /// Block-sparse, in flat states, whatever the simulation itself uses.
    MotionEquations& equations() const { return *block_; }
    /// What explicit methods integrate, and their start.
    MotionEquations& integrated() const { return other_ ? *other_ : *block_; }
    std::vector<double> integrated_start() const;

private:
    std::unique_ptr<TimeStepper> stepper(double end) const;
    void take_joints();
    bool keeps_digits(TreeEquations& tree) const;  ///< to the tolerance, beside the block equations
    void take_up_rows(double t, const std::vector<double>& y) const;
    bool counts_turns() const;
    /// Of rotational springs, from a state (flat) that the motion has reached.
    void count_turns_at(const std::vector<double>& y);
    void look_for_contradiction(const std::vector<double>& as_given);
    void look_for_contradicting_rates();
    /// Of numbers that are integrated.
    std::vector<double> flat_of(const std::vector<double>& y) const;
    /// Puts the accelerations at the end of a step back into the equations of motion.
    std::optional<SimulationFailure> failure_of_proof(
        Certificate& certificate, const TimeStepper& stepper, AccelerationResidual& worst) const;
    double tolerance_of_samples() const;
    /// One step towards `event`, and what keeps the run from going on after it.
    std::optional<SimulationFailure> failure_of_step(TimeStepper& stepper, double event, double end);
    SimulationFailure too_many_steps(const TimeStepper& stepper) const;
    /// Why no step can be taken from where the stepper is.
    SimulationFailure failure_of(const TimeStepper& stepper) const;
    /// The equation that is off most at a flat state, or whose rate is, as the failure of a cause.
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
    std::unique_ptr<MotionEquations> other_;  ///< what is integrated where it is not `block_`
    std::vector<double> start_;               ///< flat
    std::optional<SimulationFailure> contradiction_;
};

}  // namespace jw
