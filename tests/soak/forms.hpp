#pragma once

#include <string>
#include <vector>

#include "core/motion/tree/tree_equations.hpp"
#include "tests/support/random_dynamics.hpp"

/// Accelerations r̈ and ω̇' of the centroidal frames, in every form of the equations of motion.
namespace jw::test {

/// Accelerations in a flat rate.
Motion accelerations_in(const Centroidal& scene, const std::vector<double>& flat_dot);

/// Accelerations by joint coordinates at y with ẏ.
Motion accelerations_in_joints(
    TreeEquations& tree, const Centroidal& scene, double t, const std::vector<double>& y,
    const std::vector<double>& y_dot);

struct Form {
    std::string name;
    Motion accelerations;
};

/// Accelerations at the start pose: by block equations, joint coordinates, and the four dense choices.
std::vector<Form> accelerations_in_all_forms(const Centroidal& scene);

}  // namespace jw::test
