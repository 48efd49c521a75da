#pragma once

#include <optional>
#include <span>

#include "core/equations/system.hpp"
#include "core/poses/diagnosis.hpp"

/// Poses in which angles and displacements of joints have given values.
namespace jw {

/// Value of a coordinate of a joint.
struct GivenValue {
    int joint = 0;
    Measure measure;  ///< θ, the angle or the displacement of the joint
    /// [rad] or [m]; an angle counts up to whole turns, θ with them. Absent: the value is kept, unless the
    /// others change it.
    std::optional<double> value;
};

/// A given value that a joint does not take.
struct MissedValue {
    std::size_t given = 0;  ///< index among the given values
    double found = 0.0;     ///< the value that is nearest to it, of those that were reached
    /// True: drivers, joints and the values before this one determine `found`.
    bool is_determined = false;
    /// Why the motion to the given values ended at `found`. Without it, the value is determined, or no motion
    /// of the assembled pose changes it to first order.
    std::optional<PositionFailure> failure;
};

/// Moves an assembled pose to the pose of the same branch in which joints have given values: while all
/// drivers stand still, those values that are independent of the ones before them are driven from where they
/// are to where they shall be, all in the same time, by MotionTracker; an angle the shorter way round, or if
/// that way ends or crosses other branches, the other. So the branch is kept by proof if drivers and values
/// leave no freedom; what they leave free moves as little as it can. A value that depends on others is
/// compared with four digits.
/// @param state satisfies the constraints of `present` at time `t` [s]; it stays if a value is missed
std::optional<MissedValue> move_to_values(
    const Mechanism& mechanism, const Selection& present, std::span<const GivenValue> values, double t,
    State& state);

}  // namespace jw
