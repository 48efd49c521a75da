#pragma once

#include "app/hard/hard_case.hpp"

/// The cases, by the file they are in.
namespace jw::hard {

// kept_pair.cpp
Result kept_pair_at_right_angle();

// ---- kinematics
// rank_verdicts.cpp
Result loops_turned_at_random();
Result long_and_short_vectors();
// sizes.cpp
Result loops_of_any_size();
Result large_and_small_side_by_side();
// hysteresis.cpp
Result axis_at_the_diagonal();
// screw_turns.cpp
Result cosine_row_at_half_turns();
Result a_thousand_turns();
// far_starts.cpp
Result anti_parallel_start();
Result start_170_degrees_off();
// universal_joint.cpp
Result parallel_arms();
Result bend_of_90_degrees();
// change_points.cpp
Result parallelogram_through_change_points();
// redundancy.cpp
Result tilted_axis();
Result accidental_redundancy();
// near_singular.cpp
Result towards_a_change_point();

}  // namespace jw::hard
