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

    // --- dynamics ---
    Case{
        "change-points", "Four-bars through the line where they could fold",
        "Twice in every turn all rods lie in one line: the equations lose rank, and a parallelogram could go "
        "on folded.",
        "explicit-8 at tolerance 1e-6 without treatment of the constraints", "explicit-8 at tolerance 1e-9",
        "dynamics/four-bar-1.toml", four_bar_through_its_line},
    Case{
        "masses-apart", "Masses from 1e-9 to 1e9 kg in one loop",
        "Rods of Bricard's linkage weigh 1e-9, 1e9, 1e-9 ... kg: light ones carry heavy ones.",
        "λ from Φq M⁻¹ Φqᵀ", "explicit-8, equations as they choose themselves",
        "dynamics/bricard-falling.toml", masses_eighteen_decades_apart},
    Case{
        "any-size", "The same linkage from a micrometre to a thousand kilometres",
        "With lengths times s, and times times √s, nothing changes but the units.",
        "Dormand-Prince 5(4) with a tolerance of 1e-6 in SI units", "explicit-8 at tolerance 1e-9",
        "dynamics/bricard-falling.toml", scene_of_any_size},
    Case{
        "turned-scene", "The whole scene turned",
        "A mechanism must not move otherwise because somebody has laid his axes otherwise.",
        "the rows x and y of every axis, as they are right for z", "explicit-8 at tolerance 1e-13",
        "dynamics/four-bar-1.toml", scene_turned},
    Case{
        "stiff-governor", "A governor with stiff dampers",
        "Its dampers settle in microseconds, its balls swing in a second: one must follow the second without "
        "counting the first.",
        "explicit-8", "implicit-5 and implicit-9", "dynamics/governor.toml", stiff_governor},
    Case{
        "million-steps", "A million steps of a free body",
        "Nothing holds it but its own equations, so all that a method does wrong adds up.",
        "p is never normalised", "p to unit length after every step", "dynamics/free-asymmetric-body.toml",
        million_steps_of_a_free_body},
    Case{
        "drift", "A pendulum that leaves its pin",
        "Accelerations obey Φq q̈ = γ, but that is two derivatives away from Φ = 0.",
        "treatment none, then Baumgarte's with α = 20 / s and 200 / s", "treatment projection",
        "dynamics/simple-pendulum.toml", drift_off_the_constraints},
    Case{
        "rank-in-every-stage", "The rank decided in every stage",
        "One of 30 rows repeats the others exactly on the constraints and nowhere else.",
        "explicit-8, all rows in a rank-revealing factorisation", "explicit-8 at tolerance 1e-6",
        "dynamics/bricard-falling.toml", rank_in_every_stage},
    Case{
        "orders", "The order of every method, measured",
        "An order gets lost without a sound. Halve the steps, and the error must fall by 2 to the order.",
        "rk4 that turns bodies by averages of ω'", "every method with steps halved",
        "dynamics/chain-spherical-4.toml", orders_measured},
    Case{
        "energy-is-not-accuracy", "Energy is not accuracy", "A method can keep the energy and be elsewhere.",
        "explicit Euler, velocities scaled after every step so that the energy fits",
        "explicit-8 at tolerance 1e-9", "dynamics/chain-revolute-4.toml", energy_is_not_accuracy},
    Case{
        "which-reactions", "Which forces are in the joints",
        "Where rows repeat each other, joints can be braced against each other, and forces are not unique.",
        "the first rows that are independent, then the last", "the smallest answer and its family",
        "dynamics/four-bar-1.toml", which_reactions},
    Case{
        "middle-axis", "Turning about the middle axis",
        "A free body turns over again and again; a small error at one flip is a large one at the next.",
        "explicit Euler with steps of 1 ms", "explicit-8 at tolerance 1e-12",
        "dynamics/free-asymmetric-body.toml", turning_about_the_middle_axis},
    Case{
        "tilted-axis", "A loop with one axis tilted",
        "Three of 20 rows of a four-bar repeat others. With its last axis tilted by 5 degrees they ask for "
        "something else.",
        "rows that repeat others are left out, and nobody looks at them again", "simulate as it is",
        "dynamics/four-bar-1.toml", loop_with_a_tilted_axis},
};

}  // namespace

std::span<const Case> cases() { return kCases; }

}  // namespace jw::hard
