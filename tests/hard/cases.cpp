#include "tests/hard/cases.hpp"

#include <array>

namespace jw::hard {

namespace {

constexpr std::array kCases{
    Case{
        "kept-pair-at-90", "The kept pair driven to 90 degrees",
        "Two of the three rows of a parallel constraint are independent; which two depends on the direction "
        "of the axis. If the axis of a revolute joint turns with its first body by 90 degrees, the pair "
        "chosen at the start becomes dependent.",
        "the pair of the start is kept", "the rule chooses the pair again at every pose",
        "parallel/which-two-of-three.toml", kept_pair_at_right_angle},
    // ---- kinematics
    Case{
        "turned-scenes", "Overconstrained loops turned at random",
        "Bennett's and Bricard's linkages, a planar four-bar and a double Scott-Russell linkage move, "
        "although counting of freedoms says that they are rigid. The number of independent equations must "
        "not depend on how the scene is turned.",
        "counting of freedoms, and the rank in (r, p)", "singular values of (r, ω')", "loops/bennett.toml",
        loops_turned_at_random},
    Case{
        "any-size", "From micrometres to a thousand kilometres",
        "The same loops with all lengths multiplied by 10^-6 to 10^6. Singular values that belong to lengths "
        "are compared with those that belong to angles.",
        "elimination with full pivoting, |entry| <= 1e-6 is zero; Newton until |Φ| < 1e-6",
        "singular values in the scene's unit of length", "loops/double-scott-russell.toml",
        loops_of_any_size},
    Case{
        "two-sizes", "A watch in a crane",
        "Each of these loops and a copy of it a million times as small, in one scene and one matrix.",
        "elimination with full pivoting, |entry| <= 1e-6 is zero", "singular values, threshold 10^-9",
        "loops/bricard.toml", large_and_small_side_by_side},
    Case{
        "any-vectors", "Long and short vectors",
        "An axis is a direction, so a lesson may give it any length, but |s_i| and |s_j| multiply the "
        "equation. Here each vector has a different length between 10^-6 and 10^6.",
        "elimination with full pivoting, |entry| <= 1e-6 is zero",
        "every row divided by its own size |s_i||s_j|", "loops/bricard.toml", long_and_short_vectors},
    Case{
        "diagonal-axis", "An axis at the diagonal, with noise",
        "For an axis along (1, 1, 1) all three pairs of rows are equally good, so rounding decides which one "
        "is the best.",
        "the rule without hysteresis", "the rule with hysteresis", "parallel/which-two-of-three.toml",
        axis_at_the_diagonal},
    Case{
        "cosine-row", "The cosine row of the screw",
        "Slide 11 determines θ by the cosine of the angle between two vectors.", "u_i · u_j - cos θ = 0",
        "(u_i x u_j) · s cos θ - (u_i · u_j) sin θ = 0", "hard/cosine-row.toml", cosine_row_at_half_turns},
    Case{
        "thousand-turns", "A thousand turns of a screw",
        "Two directions determine the angle between them only up to whole turns, but a nut moves by 0.12 m "
        "with each turn.",
        "θ measured by atan2", "θ as a coordinate", "joints/screw.toml", a_thousand_turns},
    Case{
        "anti-parallel", "Parallel, but the wrong way round",
        "Anti-parallel axes satisfy p1 just as parallel axes do.", "plain Newton, no check of the branch",
        "Newton with limited steps, wrong branches recognised and left", "hard/anti-parallel.toml",
        anti_parallel_start},
    Case{
        "start-170-deg-off", "A start 170 degrees off",
        "In a student's start estimate, the body is nearly upside down.",
        "plain Newton, no check of the branch",
        "Newton with limited steps, wrong branches recognised and left", "hard/anti-parallel.toml",
        start_170_degrees_off},
    Case{
        "parallel-arms", "A universal joint whose arms start parallel",
        "n1 requires perpendicular arms; where they are parallel, its derivative is zero.", "plain Newton",
        "Newton with limited steps, then a diagnosis", "joints/universal.toml", parallel_arms},
    Case{
        "bend-90", "Two shafts at right angles",
        "At a bend of 90 degrees a universal joint transmits no rotation: one shaft is locked, and in one "
        "pose two branches of motion cross. None of this happens where the shafts are parallel.",
        "the normal equations JᵀJ q̇ = Jᵀν", "rank-revealing least squares with a verdict",
        "loops/cardan.toml", bend_of_90_degrees},
    Case{
        "change-points", "A parallelogram through its change points",
        "Twice in every turn all bars lie in one line. Two branches cross there, the parallelogram and the "
        "crossed linkage, and both satisfy every equation.",
        "Newton from the last pose", "a proof for every step", "loops/parallelogram.toml",
        parallelogram_through_change_points},
    Case{
        "tilted-axis", "Redundant, or contradictory?",
        "Three equations of a planar four-bar are redundant as long as its axes are parallel. If one axis is "
        "tilted, these equations contradict the others.",
        "the redundant equations are left out permanently", "all equations are kept and checked",
        "loops/four-bar.toml", tilted_axis},
    Case{
        "accidental-redundancy", "Redundant by structure, or by accident?",
        "Some equations are redundant for any lengths, others only for exactly these. The points of the "
        "joints are moved a little, the axes keep their directions, the loop stays closed, and the rank is "
        "determined again.",
        "the rows chosen for the perfect geometry are kept", "the rank is determined at the new geometry",
        "loops/double-scott-russell.toml", accidental_redundancy},
    Case{
        "near-singular", "Closer and closer to a change point",
        "The parallelogram is 10^-1 to 10^-7 rad from the pose where its bars are in line. A condition "
        "number of 10^k costs k digits; more need not be lost.",
        "the normal equations JᵀJ q̇ = Jᵀν", "pivoted QR", "loops/parallelogram.toml", towards_a_change_point},

    // ---- dynamics
    Case{
        "falling-through-the-line", "Four-bars through the line where they could fold",
        "Twice in every turn all rods lie in one line. The equations lose rank there, and a parallelogram "
        "could continue folded.",
        "explicit-8 at tolerance 1e-6 without treatment of the constraints", "explicit-8 at tolerance 1e-9",
        "dynamics/four-bar-1.toml", four_bar_through_its_line},
    Case{
        "masses-apart", "Masses from 1e-9 to 1e9 kg in one loop",
        "Rods of Bricard's linkage have masses of 1e-9, 1e9, 1e-9 ... kg: light rods carry heavy ones.",
        "λ from Φq M⁻¹ Φqᵀ", "explicit-8, with the equations chosen by default",
        "dynamics/bricard-falling.toml", masses_eighteen_decades_apart},
    Case{
        "falling-at-any-size", "The same linkage from a micrometre to a thousand kilometres",
        "With lengths multiplied by s and times by √s, only the units change.",
        "Dormand-Prince 5(4) with a tolerance of 1e-6 in SI units", "explicit-8 at tolerance 1e-9",
        "dynamics/bricard-falling.toml", scene_of_any_size},
    Case{
        "turned-scene", "The whole scene turned",
        "The motion of a mechanism must not depend on the choice of the global axes.",
        "the rows x and y of every axis, which are right for axes along z", "explicit-8 at tolerance 1e-13",
        "dynamics/four-bar-1.toml", scene_turned},
    Case{
        "stiff-governor", "A governor with stiff dampers",
        "The dampers settle in microseconds, and the balls swing in a second. A method must follow the swing "
        "without resolving the damping.",
        "explicit-8", "implicit-5 and implicit-9", "dynamics/governor.toml", stiff_governor},
    Case{
        "million-steps", "A million steps of a free body",
        "No joint holds the body, so every error of a method adds up.", "p is never normalised",
        "p is normalised after every step", "dynamics/free-asymmetric-body.toml",
        million_steps_of_a_free_body},
    Case{
        "drift", "A pendulum that leaves its pin",
        "Accelerations satisfy Φq q̈ = γ, but this is only the second derivative of Φ = 0.",
        "treatment none, then Baumgarte's with α = 20 / s and 200 / s", "treatment projection",
        "dynamics/simple-pendulum.toml", drift_off_the_constraints},
    Case{
        "rank-in-every-stage", "The rank decided in every stage",
        "One of 30 rows is redundant, but only where the constraints hold exactly.",
        "explicit-8, all rows in a rank-revealing factorisation", "explicit-8 at tolerance 1e-6",
        "dynamics/bricard-falling.toml", rank_in_every_stage},
    Case{
        "orders", "The order of every method, measured",
        "A method can lose its order unnoticed. When the steps are halved, the error must fall by 2 to the "
        "power of the order.",
        "rk4 that turns bodies by averages of ω'", "every method with steps halved",
        "dynamics/chain-spherical-4.toml", orders_measured},
    Case{
        "energy-is-not-accuracy", "Energy is not accuracy",
        "A method can conserve energy and still give wrong positions.",
        "explicit Euler, velocities scaled after every step so that the energy fits",
        "explicit-8 at tolerance 1e-9", "dynamics/chain-revolute-4.toml", energy_is_not_accuracy},
    Case{
        "which-reactions", "Which forces are in the joints",
        "Where rows are redundant, joints can be braced against each other, and their forces are not unique.",
        "the first independent rows, then the last ones",
        "the smallest solution and the family of all others", "dynamics/four-bar-1.toml", which_reactions},
    Case{
        "middle-axis", "Turning about the middle axis",
        "A free body turns over again and again; a small error at one flip becomes a large one at the next.",
        "explicit Euler with steps of 1 ms", "explicit-8 at tolerance 1e-12",
        "dynamics/free-asymmetric-body.toml", turning_about_the_middle_axis},
    Case{
        "pair-kept-while-falling", "A falling chain that keeps its pairs of equations",
        "The axes of a chain in space turn through all directions, so the pair of independent equations "
        "changes.",
        "the pairs of the start are kept", "the rule chooses again after every step",
        "dynamics/chain-revolute-4.toml", pair_kept_while_falling},
    Case{
        "wound-spring", "A spring wound by four turns",
        "The pose of a body determines its angle only up to whole turns, but the torque of the spring "
        "depends on all turns.",
        "θ by atan2, rk4", "explicit-8 at tolerance 1e-10", "dynamics/torsion-pendulum.toml", wound_spring},
    Case{
        "falling-tilted-loop", "A loop with one axis tilted",
        "Three of the 20 rows of a four-bar are redundant. With its last axis tilted by 5 degrees they "
        "contradict the others.",
        "rk4 with projection; redundant rows are left out and never checked again",
        "simulate with default settings", "dynamics/four-bar-1.toml", loop_with_a_tilted_axis},
};

}  // namespace

std::span<const Case> cases() { return kCases; }

}  // namespace jw::hard
