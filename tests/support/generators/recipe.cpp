#include "tests/support/generators/recipe.hpp"

namespace jw::test {

std::ostream& operator<<(std::ostream& out, const Recipe& r) {
    out << "recipe family " << static_cast<int>(r.family) << " near " << r.near << " length 1e"
        << r.length_decade << " gravity " << r.gravity << " rest " << r.at_rest << " all driven "
        << r.drive_all << (r.afloat ? " afloat" : "") << " seed " << r.seed << '\n';
    for (const BodyRecipe& b : r.bodies) {
        out << "  body on " << b.parent << " joint " << b.joint << " form " << b.form << " mass 1e"
            << b.mass_decade << " offset " << b.offset << " seed " << b.seed << '\n';
    }
    for (const JointRecipe& j : r.joints) {
        out << "  joint " << j.type << " of " << j.i << ' ' << j.j << " form " << j.form << " repeats "
            << j.repeats << " without " << j.without << " seed " << j.seed << '\n';
    }
    for (const DriverRecipe& d : r.drivers) {
        out << "  driver " << d.quantity << " joint " << d.joint << " of " << d.i << ' ' << d.j
            << " function " << d.function << " seed " << d.seed << '\n';
    }
    for (const LoadRecipe& l : r.loads) {
        out << "  load " << l.kind << " of " << l.i << ' ' << l.j << " damped " << l.damped << " seed "
            << l.seed << '\n';
    }
    return out;
}

}  // namespace jw::test
