#pragma once

#include <iosfwd>
#include <optional>
#include <vector>

/// Recipes of generated mechanisms: small numbers only, of which every combination is a recipe.
/// `mechanism_of` builds the mechanism. A failing recipe is made smaller by leaving out parts of it: numbers
/// that point at a body or a joint do so modulo the number of those.
namespace jw::test {

/// Arrangement of the axes and points of the joints.
enum class Family {
    general,    ///< anywhere
    planar,     ///< axes across one plane, slides in it: loops close with rows that repeat others
    concurrent  ///< axes through one point: the same on a sphere
};

/// A moving body and the joint that it hangs from.
struct BodyRecipe {
    int parent = 0;  ///< 0 ground, else a body before it
    int joint = 0;   ///< joint type, modulo kJointTypes; kFreeBody: none
    int form = 0;    ///< of p1 and p2
    int mass_decade = 0;
    bool offset = false;  ///< its centre of mass lies beside its origin
    int seed = 0;
};
inline constexpr int kFreeBody = -1;

/// A joint between any two bodies: it closes a loop, or is one equation between two arms.
struct JointRecipe {
    int type = 0;
    int i = 0;
    int j = 0;
    int form = 0;
    bool repeats = false;  ///< taken even if it is redundant
    int without = 0;       ///< > 0: so-many-th equation is taken out by hand, where the form allows it
    int seed = 0;
};

struct DriverRecipe {
    int quantity = 0;  ///< angle or θ, displacement, distance, coordinate
    int joint = 0;
    int i = 0;
    int j = 0;
    int function = 0;  ///< polynomial, harmonic, step, all of them; from 4 on with a table, every other also
                       ///< with a formula
    int seed = 0;
};

struct LoadRecipe {
    int kind = 0;  ///< spring, turning spring, force, torque; from 4 on the spring along an axis, the torque
                   ///< against the other body
    int i = 0;
    int j = 0;
    bool damped = false;
    int seed = 0;
};

struct Recipe {
    Family family = Family::general;
    int near = 0;  ///< 10^-near of the size is what joints lie beside a line or a pole; 0: they lie anywhere
    int length_decade = 0;  ///< of the whole scene
    bool gravity = true;
    bool at_rest = false;
    bool drive_all = false;  ///< every joint of the tree that can be driven is
    bool afloat =
        false;  ///< nothing hangs from the ground: a free body is in its place, all forces are inner
    int seed = 0;
    std::vector<BodyRecipe> bodies;
    std::vector<JointRecipe> joints;
    std::vector<DriverRecipe> drivers;
    std::vector<LoadRecipe> loads;
};

std::ostream& operator<<(std::ostream& out, const Recipe& recipe);

/// The recipe that was written among other lines; nothing where there is none.
std::optional<Recipe> recipe_in(std::istream& text);

}  // namespace jw::test
