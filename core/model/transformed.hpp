#pragma once

#include "core/model/mechanism.hpp"

/// A mechanism laid otherwise or made larger: verdicts on it must stay what they are.
namespace jw {

/// The whole scene, ground included, turned by p about the origin and then moved by r [m]. What drivers
/// prescribe is left alone.
Mechanism moved_rigidly(Mechanism mechanism, const Vec4& p, const Vec3& r = Vec3::Zero());

/// Every length of the bodies and joints times `factor`; drivers are left alone.
Mechanism scaled(Mechanism mechanism, double factor);

}  // namespace jw
