#pragma once

#include "core/model/mechanism.hpp"

/// A mechanism that is moved or scaled: verdicts on it must stay the same.
namespace jw {

/// The whole scene, ground included, turned by p about the origin and then moved by r [m]. The values that
/// drivers prescribe are unchanged.
Mechanism moved_rigidly(Mechanism mechanism, const Vec4& p, const Vec3& r = Vec3::Zero());

/// Every length of the bodies and joints times `factor`; drivers are unchanged.
Mechanism scaled(Mechanism mechanism, double factor);

}  // namespace jw
