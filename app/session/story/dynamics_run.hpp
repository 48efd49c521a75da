#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/integrate/simulation.hpp"
#include "core/quantity/names.hpp"
#include "lessons/lesson/lesson.hpp"

/// A lesson of dynamics, run from its start.
namespace jw {

/// Settings of a run; the lesson's own unless others are asked for.
struct DynamicsRequest {
    SimulationSettings settings;
    double duration = 1.0;  ///< [s]
    int samples = 100;      ///< equal intervals
    bool reactions = false;
    std::vector<NamedQuantity> quantities = {};  ///< additional columns
    /// True if somebody chose the method. Otherwise, a method that stability makes very slow is replaced by
    /// implicit-5.
    bool method_chosen = false;
    /// Called with each note as soon as it is known: on the start, or that the run will take long and what
    /// helps.
    std::function<void(const std::string& note)> tell = {};
    std::function<void(double fraction)> progress = {};
};

/// Most steps that `simulate` takes unless more are allowed: minutes, not hours.
inline constexpr long kMostStepsUnasked = 1'000'000;
/// @throws std::invalid_argument if the lesson has no [dynamics]
DynamicsRequest request_of(const Lesson& lesson);

/// One row per time, with the values that `columns` names. column_of finds a column by its name.
struct DynamicsTable {
    std::vector<std::string> columns;
    std::vector<std::vector<double>> rows;
    SimulationOutcome outcome;
    std::string summary;     ///< steps, evaluations, drift in words
    std::string failure;     ///< what went wrong, where and why; empty if nothing did
    std::string start_note;  ///< see start_note
    std::string pace_note;   ///< that the run would take long, or that another method was taken
    std::string fit_note;    ///< that a loop does not quite fit, if that decides its branch
    /// Joints whose reactions are not unique; only if reactions were asked for.
    std::vector<std::string> not_unique;
    /// Largest row of M q̈ − Q that the reactions do not explain, relative to |M q̈| + |Q|, and its bound;
    /// only if reactions were asked for.
    std::optional<double> reaction_residual;
    double reaction_bound = 0.0;
    std::string reaction_note;  ///< that the residual exceeds its bound, and where first; mostly empty

    /// Index of a column in every row. @throws std::invalid_argument if no column has that name
    std::size_t column_of(std::string_view name) const;
};

DynamicsTable simulate(const Lesson& lesson, const DynamicsRequest& request);

/// Times at equal intervals from 0 to `duration`.
std::vector<double> equal_times(double duration, int intervals);

/// The mechanism with its bodies at the poses of a state.
Mechanism placed_at(const Mechanism& mechanism, const State& state);

/// Says which start values the constraints do not allow and what is used instead; empty if all are used as
/// given.
/// @param start of the simulation, at t = 0
std::string start_note(const Mechanism& given, const Snapshot& start);

/// Says that a run has left the coordinates of the joints at `t` [s].
std::string bodies_note(double t);

/// Why a simulation ended early, with what to do about it.
std::string failure_text(
    const SimulationFailure& failure, const SimulationSettings& settings, const Mechanism& mechanism);
/// Failure text of a lesson that was not assembled before its run: a driver that starts out of reach is
/// described as in the story.
std::string failure_text(
    const SimulationFailure& failure, const SimulationSettings& settings, const Lesson& lesson);

}  // namespace jw
