#pragma once

#include <map>

#include "core/integrate/simulation.hpp"
#include "core/quantity/evaluate.hpp"
#include "core/quantity/names.hpp"
#include "lessons/lesson/lesson.hpp"

/// Rows of a table over a motion by masses and forces.
namespace jw {

/// Instant of a run at one of its times, with the energies that the run has summed up and the accelerations
/// of its equations.
/// @param with_accelerations they cost one evaluation
Instant instant_of(
    Simulation& simulation, const Snapshot& snapshot, const std::vector<double>& y,
    std::shared_ptr<const Centroidal> scene, std::shared_ptr<const System> system, bool with_accelerations);

// Tolerances of the trusted run, and of the run that shows how far it can be trusted. After a change point
// (lesson four-bar-1), 1e-8 leaves an error of 1e-6 of the scene, as much as claims allow; the tolerances
// below leave a tenth of it.
inline constexpr double kTightRun = 1e-10;
inline constexpr double kLooseRun = 3e-9;

struct RunLimits {
    double tolerance = kTightRun;
    long most_steps = 0;
};
/// Instants of the lesson's motion by masses and forces at ascending `times`, by explicit-8 or by the
/// lesson's implicit method.
/// @return why the run ended early, or nothing
std::string instants_by_forces(
    const Lesson& lesson, const RunLimits& limits, const std::vector<double>& times,
    std::map<double, Instant>& found);

/// The rows of `simulate`, one after the other.
class DynamicsRows {
public:
    /// @param further additional columns; `lesson` and `simulation` must outlive the rows
    DynamicsRows(const Lesson& lesson, const std::vector<NamedQuantity>& further, Simulation& simulation);

    std::vector<std::string> columns() const;
    std::vector<double> row(const Snapshot& now, const std::vector<double>& y);

private:
    std::vector<NamedQuantity> further_;
    Simulation* simulation_;
    std::vector<NamedQuantity> list_;
    std::shared_ptr<System> system_;
    std::shared_ptr<const Centroidal> scene_;
};

}  // namespace jw
