#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/session/view/inspection.hpp"
#include "core/kinematics/proof/proof_record.hpp"
#include "core/quantity/names.hpp"
#include "lessons/lesson/enum_words.hpp"

/// Position, velocity and acceleration analysis over a sweep of time, as a table of numbers.
namespace jw {

enum class Analysis { position, velocity, acceleration };
inline constexpr std::array kAnalyses{
    EnumWord<Analysis>{Analysis::position, "position"}, EnumWord<Analysis>{Analysis::velocity, "velocity"},
    EnumWord<Analysis>{Analysis::acceleration, "acceleration"}};

struct SweepPlan {
    Analysis analysis = Analysis::position;
    double from = 0.0;   ///< [s]
    double to = 1.0;     ///< [s], >= from
    double step = 0.01;  ///< [s], > 0; the last interval may be shorter
    /// Columns in addition to those of the analysis.
    std::vector<NamedQuantity> quantities = {};
    bool with_proof = false;
};

struct SweepRow {
    std::vector<double> values;  ///< one per column
    bool unique = true;          ///< velocities (and accelerations) are determined by the equations
    bool consistent = true;      ///< no equation contradicts the others
    bool change_point = false;
    KinematicResiduals residuals;  ///< as far as the analysis goes; the others have no meaning
};

struct Sweep {
    std::vector<std::string> columns;  ///< "time_s", "crank.x", "crank.e0", "crank.omega_local.x", ...
    std::vector<SweepRow> rows;
    std::vector<double> crossings;  ///< as MotionTracker::crossings
    std::string failure;            ///< empty, or why the sweep ended early
    /// Which equations first contradict each other in velocities or accelerations; empty if none do.
    std::string contradiction;
    /// Proof, with the system whose motion it proves; none if not asked for.
    std::optional<ProofRecord> proof;
    std::shared_ptr<const System> system;
};

/// @throws PoseNotReached if the mechanism cannot be assembled
Sweep solve_sweep(
    const Lesson& lesson, const SweepPlan& plan, const std::function<void(double fraction)>& progress = {});

}  // namespace jw
