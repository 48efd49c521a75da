#pragma once

#include "core/equations/system.hpp"
#include "jointwise/analysis.hpp"

/// Conversion of core's states and motions to those of the library, and back.
namespace jointwise {
inline namespace JOINTWISE_ABI {

inline Pose pose_of(const jw::State& state, double t) { return {t, state.r, state.p, state.theta}; }
inline Rates rates_of(const jw::Motion& motion) {
    return {motion.r_dot, motion.omega_local, motion.theta_dot};
}

/// @throws std::invalid_argument if there is not one entry per body and screw, or a number is not finite
void read_state(const jw::Mechanism& mechanism, const Pose& pose, jw::State& state);
void read_motion(const jw::Mechanism& mechanism, const Rates& rates, jw::Motion& motion);
jw::State state_of(const jw::Mechanism& mechanism, const Pose& pose);
jw::Motion motion_of(const jw::Mechanism& mechanism, const Rates& rates);

/// A number for messages, with six digits.
std::string number_text(double value);

/// "hinge.p1.y", the name of a row.
std::string row_name(const jw::System& system, int row);

/// @throws std::invalid_argument unless there are times, finite and ascending
void expect_ascending(const std::vector<double>& times);

}  // namespace JOINTWISE_ABI
}  // namespace jointwise
