#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/support/generators/mechanism_of.hpp"

/// Property that must hold for every mechanism.
namespace jw::test {

struct Verdict {
    enum class Kind { holds, fails, not_asked };
    Kind kind = Kind::holds;
    std::string why;  ///< what is wrong and by how much, or why it was not asked
};
inline Verdict holds() { return {}; }
inline Verdict fails(const std::string& why) { return {Verdict::Kind::fails, why}; }
/// Verdict for a mechanism that the property does not apply to.
inline Verdict not_asked(const std::string& why) { return {Verdict::Kind::not_asked, why}; }

struct Property {
    std::string name;  ///< one word for the command line
    std::string says;  ///< a sentence that can be false
    int most_bodies;   ///< approximate number in the largest mechanisms
    std::function<Verdict(const Generated&)> of;
    /// Converts a recipe first, for properties of mechanisms of one kind; empty: no conversion. Converting
    /// twice changes nothing more.
    std::function<Recipe(Recipe)> kind = {};
};

/// All properties.
const std::vector<Property>& properties();

Verdict accelerations_agree(const Generated& generated);
Verdict methods_converge(const Generated& generated);
Verdict rank_agrees(const Generated& generated);
Verdict jacobians_agree(const Generated& generated);
Verdict spectra_agree(const Generated& generated);
Verdict kinematics_agree(const Generated& generated);
Verdict assembles_again(const Generated& generated);
Verdict reactions_balance(const Generated& generated);
Verdict power_balances(const Generated& generated);
Verdict momentum_stays(const Generated& generated);
Verdict answers_transform(const Generated& generated);
Verdict comes_back(const Generated& generated);
Verdict joints_multiply(const Generated& generated);

/// Recipe in which the rule chooses rows: two rows that are kept by hand may lose their rank on the way.
Recipe without_rows_by_hand(Recipe recipe);
/// Recipe whose bodies are not connected to the ground; all forces are between the bodies.
Recipe afloat(Recipe recipe);
/// Recipe of a tree in which every freedom of the joints is driven.
Recipe driven_tree(Recipe recipe);

}  // namespace jw::test
