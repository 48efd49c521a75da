#include "app/hard/cases.hpp"

#include <array>

namespace jw::hard {

namespace {

constexpr std::array kCases{
    Case{
        "kept-pair-at-90", "The kept pair driven to 90 degrees",
        "Two of the three rows of a parallel constraint are independent, but which two depends on the axis: "
        "a revolute joint whose axis turns with its first body by 90 degrees loses the pair chosen at the "
        "start.",
        "the pair of the start is kept", "the rule chooses again at every pose",
        "parallel/which-two-of-three.toml", kept_pair_at_right_angle},
    // ---- kinematics
    Case{
        "turned-scenes", "Overconstrained loops turned at random",
        "Bennett's and Bricard's linkages, a planar four-bar and a double Scott-Russell linkage move "
        "although "
        "counting says no. How many of their equations are independent must not depend on how the scene "
        "lies.",
        "counting, and the rank of (r, p) as it stands", "singular values of (r, ω')", "loops/bennett.toml",
        loops_turned_at_random},
    Case{
        "any-size", "From micrometres to a thousand kilometres",
        "The same loops with all lengths multiplied by 10^-6 to 10^6: a singular value of a length and one "
        "of "
        "an angle are compared with each other.",
        "elimination with full pivoting, |entry| <= 1e-6 is zero; Newton until |Φ| < 1e-6",
        "singular values in the scene's unit of length", "loops/double-scott-russell.toml",
        loops_of_any_size},
    Case{
        "two-sizes", "A watch in a crane",
        "Each of these loops beside itself a million times as small, in one scene and one matrix.",
        "elimination with full pivoting, |entry| <= 1e-6 is zero", "singular values, threshold 10^-9",
        "loops/bricard.toml", large_and_small_side_by_side},
    Case{
        "any-vectors", "Long and short vectors",
        "An axis is a direction, so a lesson may write it with any length; yet |s_i| and |s_j| multiply the "
        "equation. Here each vector has a length of its own between 10^-6 and 10^6.",
        "elimination with full pivoting, |entry| <= 1e-6 is zero",
        "every row divided by its own size |s_i||s_j|", "loops/bricard.toml", long_and_short_vectors},
    Case{
        "diagonal-axis", "An axis at the diagonal, with noise",
        "For an axis along (1, 1, 1) all three pairs of rows are equally good: which one is the best is "
        "decided by rounding.",
        "the rule without hysteresis", "the rule with hysteresis", "parallel/which-two-of-three.toml",
        axis_at_the_diagonal},
    Case{
        "cosine-row", "The cosine row of the screw",
        "Slide 11 ties θ to the angle between two vectors by their cosine.", "u_i · u_j - cos θ = 0",
        "(u_i x u_j) · s cos θ - (u_i · u_j) sin θ = 0", "hard/cosine-row.toml", cosine_row_at_half_turns},
    Case{
        "thousand-turns", "A thousand turns of a screw",
        "Two directions know their angle up to whole turns only; a nut knows the difference, 0.12 m each.",
        "θ measured by atan2", "θ as a coordinate", "joints/screw.toml", a_thousand_turns},
    Case{
        "anti-parallel", "Parallel, but the wrong way round",
        "Anti-parallel axes satisfy p1 as well as parallel ones.", "plain Newton, no check of the branch",
        "Newton with limited steps, wrong branches recognised and left", "hard/anti-parallel.toml",
        anti_parallel_start},
    Case{
        "start-170-deg-off", "A start 170 degrees off",
        "A student's start estimate: the body is nearly upside down.", "plain Newton, no check of the branch",
        "Newton with limited steps, wrong branches recognised and left", "hard/anti-parallel.toml",
        start_170_degrees_off},
    Case{
        "parallel-arms", "A universal joint whose arms start parallel",
        "n1 asks for perpendicular arms; where they are parallel, its derivative vanishes.", "plain Newton",
        "Newton with limited steps, then a diagnosis", "joints/universal.toml", parallel_arms},
    Case{
        "bend-90", "Two shafts at right angles",
        "At a bend of 90 degrees a universal joint turns nothing: one shaft is locked, and in one pose two "
        "ways "
        "of moving cross. Nothing of that happens where the shafts become parallel.",
        "the normal equations JᵀJ q̇ = Jᵀν", "rank-revealing least squares with a verdict",
        "loops/cardan.toml", bend_of_90_degrees},
    Case{
        "change-points", "A parallelogram through its change points",
        "Twice a turn all bars lie in one line, and there two branches cross: the parallelogram and the "
        "crossed "
        "one. Every equation holds on both.",
        "Newton from the last pose", "prediction along the tangent, checked", "loops/parallelogram.toml",
        parallelogram_through_change_points},
    Case{
        "tilted-axis", "Redundant, or contradictory?",
        "Three equations of a planar four-bar repeat others, as long as its axes are parallel. Tilt one of "
        "them, "
        "and what repeated now contradicts.",
        "the redundant equations are left out once and for all", "all equations are kept and asked",
        "loops/four-bar.toml", tilted_axis},
    Case{
        "accidental-redundancy", "Redundant by structure, or by accident?",
        "Some equations repeat others for any lengths, some only for exactly these. Points of the joints are "
        "moved a little, axes keep their directions, the loop stays closed, and one looks again.",
        "the rows kept for the perfect geometry", "rank at the new geometry",
        "loops/double-scott-russell.toml", accidental_redundancy},
    Case{
        "near-singular", "Closer and closer to a change point",
        "The parallelogram 10^-1 to 10^-7 rad from the pose where its bars are in line. A condition number "
        "of "
        "10^k costs k digits; more need not be lost.",
        "the normal equations JᵀJ q̇ = Jᵀν", "pivoted QR", "loops/parallelogram.toml", towards_a_change_point},
};

}  // namespace

std::span<const Case> cases() { return kCases; }

}  // namespace jw::hard
