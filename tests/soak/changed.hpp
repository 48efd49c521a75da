#pragma once

#include "tests/reference/real.hpp"
#include "tests/support/generators/mechanism_of.hpp"
#include "tests/support/random_mechanisms.hpp"

/// Equivalent mechanisms: placed elsewhere, in a mirror, in other units, or backwards in time.
namespace jw::test {

/// Map of the world: x -> length · R S x + shift, with S = diag(1, 1, -1) in a mirror.
struct Change {
    Vec4 p = Vec4::Unit(0);     ///< of the rotation R
    Vec3 shift = Vec3::Zero();  ///< [m]
    bool mirrored = false;
    double length = 1.0;  ///< factor of all lengths
    double mass = 1.0;    ///< factor of all masses
    double time = 1.0;    ///< factor of all times

    /// A direction or a force, in the frame of a body; the frames are mirrored, too.
    Vec3 local(const Vec3& v) const;
    /// Axial vector in the changed world: ω, a torque.
    Vec3 local_turning(const Vec3& v) const;
    Vec3 global(const Vec3& v) const;
    Vec3 global_turning(const Vec3& v) const;
    /// Sign of angles: a mirror makes them turn the other way.
    double hand() const { return mirrored ? -1.0 : 1.0; }
};

/// True if its equations change when the scene is turned: rows along global axes that were picked by hand,
/// Euler parameters and coordinates that are driven.
bool knows_directions(const Mechanism& mechanism);

/// @param change without rotation and shift where the mechanism knows directions
Generated changed(Generated generated, const Change& change);

/// Mechanism whose motion runs backwards from `end`: functions of time are reversed, dampers drive.
Generated played_backwards(Generated generated, double end);

}  // namespace jw::test
