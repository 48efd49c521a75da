#pragma once

#include <memory>

#include "tests/reference/ode.hpp"

/// Two formulations of the same mechanics: they differ in unknowns, equations and what a joint is.
namespace jw::reference {

/// Index 1 in absolute coordinates: r, p, v, ω (global) of every body, every joint by its equations.
std::unique_ptr<Ode> absolute_coordinates(const Scene& scene);

/// Kane's equations in joint coordinates: a joint that brings a body has coordinates and no equations; only
/// joints that close loops have equations.
std::unique_ptr<Ode> joint_coordinates(const Scene& scene);

/// Rows of S = J M⁻¹ Jᵀ to keep: largest pivot first, until the next one is redundant.
std::vector<int> independent_rows(MatX S);

}  // namespace jw::reference
