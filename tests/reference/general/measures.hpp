#pragma once

#include <vector>

#include "tests/reference/general/model.hpp"
#include "tests/reference/general/taylor.hpp"

/// Equations of a model at a state: value, rate, γ and gradient.
namespace jw::reference::general {

/// A moving body: the accelerations of its centre of mass and rotation (ω̇, global) are zero.
struct Placed {
    Vec3 c = Vec3::Zero();  ///< centre of mass [m]
    Vec4 p = Vec4::Unit(0);
    Vec3 v = Vec3::Zero();      ///< of the centre of mass
    Vec3 omega = Vec3::Zero();  ///< global
    Mat3 A = Mat3::Identity();
    Vec3 centre = Vec3::Zero();  ///< of mass, in the frame of the body
};
using PlacedBodies = std::vector<Placed>;

/// Generalised force of a unit of λ on one body of an equation.
struct Pull {
    int body = 0;
    Vec3 force = Vec3::Zero();   ///< factor of the velocity of the centre of mass
    Vec3 torque = Vec3::Zero();  ///< factor of ω, global
};
using Gradient = std::vector<Pull>;

/// Directions and points as Taylor polynomials, with ω̇ = 0: s̈ = ω × (ω × s).
TaylorVector direction_of(const PlacedBodies& bodies, const Fixed& direction);
TaylorVector point_of(const PlacedBodies& bodies, const Fixed& point);
Taylor time_function(const TimeFunction& f, Real t);
/// A formula of variables, each with its rates.
Taylor value_of(const FormulaTree& formula, const std::vector<Taylor>& variables);

/// Φ = measure - target at time t, its rate and its second derivative while no body accelerates (-γ).
Taylor phi_of(const Equation& equation, const PlacedBodies& bodies, Real t);
/// ∂(Φ̇)/∂(v, ω) by hand: the virtual work of the equation.
Gradient gradient_of(const Equation& equation, const PlacedBodies& bodies);
/// Value of an angle, in (-π, π].
Taylor angle_value(const Angle& angle, const PlacedBodies& bodies);
/// Value of a measure, without its target.
Taylor measured(const Measure& measure, const PlacedBodies& bodies);

}  // namespace jw::reference::general
