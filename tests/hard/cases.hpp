#pragma once

#include "tests/hard/hard_case.hpp"

/// The hard cases, grouped by the file that holds them.
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

// ---- dynamics
// four_bar_line.cpp
Result four_bar_through_its_line();
// masses_apart.cpp
Result masses_eighteen_decades_apart();
// scaled_scenes.cpp
Result scene_of_any_size();
Result scene_turned();
// stiff_governor.cpp
Result stiff_governor();
// million_steps.cpp
Result million_steps_of_a_free_body();
// drift.cpp
Result drift_off_the_constraints();
// rows_in_every_stage.cpp
Result rank_in_every_stage();
// measured_orders.cpp
Result orders_measured();
// energy_is_not_accuracy.cpp
Result energy_is_not_accuracy();
// which_reactions.cpp
Result which_reactions();
// middle_axis.cpp
Result turning_about_the_middle_axis();
// far_turns.cpp
Result pair_kept_while_falling();
Result wound_spring();
// tilted_loop.cpp
Result loop_with_a_tilted_axis();

}  // namespace jw::hard
