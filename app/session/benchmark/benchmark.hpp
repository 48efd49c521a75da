#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/session/story/dynamics_run.hpp"

/// Speed against error: the cost of a digit, method by method.
namespace jw {

/// Value of an error or a time that is not known.
inline constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

/// Known positions of a lesson's point at equal intervals from 0 to its duration.
struct Reference {
    std::string origin;            ///< one sentence: how it was computed
    std::vector<double> times;     ///< [s]
    std::vector<Vec3> positions;   ///< [m]
    std::vector<Vec3> velocities;  ///< [m/s]; may be empty
};
/// The stored reference of a shipped lesson, lessons/reference/NAME.csv. Nothing if there is none, or if the
/// file is not a shipped one: a copy may have been changed.
/// @throws std::runtime_error if one of its rows does not have seven numbers
std::optional<Reference> stored_reference(const std::filesystem::path& lesson_file);
/// Computes a reference in two ways that none of the compared methods uses: the equations of the bodies,
/// extrapolated, and the dense equations of the slides (for more than 20 bodies, the equations of the bodies
/// by another integrator). `origin` says which way is used, and to how many digits the two agree, or why
/// there is only one.
/// @throws Stopped if `stop` asks for it; std::runtime_error if both end early
Reference own_reference(const Lesson& lesson, const std::stop_token& stop = {});

/// Thrown by a run that was asked to stop.
struct Stopped {};

/// The largest errors of a trajectory so far.
class TrajectoryErrors {
public:
    /// The lesson, which has a point, and the reference must outlive this.
    TrajectoryErrors(const Lesson& lesson, const Reference& reference);

    /// Compares the flat state at the k-th time of the reference.
    void look_at(std::size_t k, const std::vector<double>& y);

    double position() const { return position_; }    ///< of the lesson's point [m]
    double velocity() const { return velocity_; }    ///< likewise [m/s]; 0 where the reference has none
    double violation() const { return violation_; }  ///< |Φ| relative to the size of its equation
    /// Change of energy, relative to the largest kinetic energy; NaN where nothing moves.
    double energy() const { return change_ / largest_kinetic_; }

private:
    const Reference* reference_;
    const BodyPoint* tracked_;
    Simulation simulation_;
    double position_ = 0.0;
    double velocity_ = 0.0;
    double violation_ = 0.0;
    double energy_at_start_ = 0.0;
    double change_ = 0.0;
    double largest_kinetic_ = 0.0;
};

/// Time and errors of one run.
struct BenchPoint {
    double setting = 0.0;    ///< tolerance or step [s]
    double cpu = 0.0;        ///< [s], the shortest of several runs
    double position = 0.0;   ///< largest distance from the reference [m]; NaN: the run failed
    double velocity = 0.0;   ///< likewise [m/s]; NaN where the reference has none
    double energy = 0.0;     ///< largest change / largest kinetic energy; NaN where energy is not conserved
    double violation = 0.0;  ///< largest |Φ|, relative to the size of its equation; NaN: the run failed
    IntegrationCounts counts;
    std::string failure;
};

struct BenchRun {
    std::string scene;
    Method method = Method::explicit_8;
    Treatment treatment = Treatment::projection;
    std::vector<BenchPoint> points;  ///< from the loosest to the tightest setting

    /// Shortest time of a run whose position error is at most `error` [s].
    std::optional<double> time_to(double error) const;
};

struct BenchPlan {
    std::vector<Method> methods;  ///< empty: explicit-5, -8 and, with projection, implicit-5, -9
    Treatment treatment = Treatment::projection;
    Formulation formulation = Formulation::automatic;
    double least_time = 0.02;  ///< runs are repeated until this much CPU time has passed [s]
};

/// Observer of a running sweep.
struct BenchWatch {
    /// Called after every point with all runs so far; the last one is not finished.
    std::function<void(const std::vector<BenchRun>&)> seen = [](const std::vector<BenchRun>&) {};
    std::stop_token stop;  ///< stops at the next sample of the present run
};

/// The sweep of one lesson by all methods of the plan.
/// @throws Stopped if the watch asks for it
std::vector<BenchRun> bench_dynamics(
    const Lesson& lesson, const Reference& reference, const BenchPlan& plan, const BenchWatch& watch = {});

}  // namespace jw
