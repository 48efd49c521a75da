#pragma once

#include "core/model/mechanism.hpp"
#include "tests/support/generators/recipe.hpp"
#include "tests/support/random_mechanisms.hpp"

/// Placement of bodies, points and axes of a generated mechanism, and the geometry of joints that fit there.
namespace jw::test {

class Placing {
public:
    explicit Placing(const Recipe& recipe);

    Body ground() const;
    /// A moving body, whose random start velocity does not satisfy constraints yet.
    Body body(const std::string& name, int seed) const;
    /// A joint between two bodies that holds where they are.
    Joint joint(const Mechanism& mechanism, const JointType& type, int i, int j, int form, int seed) const;
    /// The type that the family allows in place of `number`.
    const JointType& type_of(int number) const;

    double length() const { return length_; }

private:
    Vec3 point(Random& random) const;
    Vec3 axis(Random& random, const Vec3& through, const JointType& type) const;

    Family family_;
    double length_;
    double beside_;  ///< how far points lie beside their line, by the size of the scene
    Vec3 origin_;    ///< of the line, and the centre of concurrent axes
    Vec3 normal_;    ///< of the plane of planar scenes
    Vec3 along_;     ///< the line that points lie near, in the plane
};

}  // namespace jw::test
