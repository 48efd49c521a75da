#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/support/generators/mechanism_of.hpp"

/// What must be true of every mechanism.
namespace jw::test {

struct Verdict {
    enum class Kind { holds, fails, not_asked };
    Kind kind = Kind::holds;
    std::string why;  ///< what is wrong and by how much, or why it was not asked
};
inline Verdict holds() { return {}; }
inline Verdict fails(const std::string& why) { return {Verdict::Kind::fails, why}; }
/// For a mechanism that the question makes no sense for.
inline Verdict not_asked(const std::string& why) { return {Verdict::Kind::not_asked, why}; }

struct Property {
    std::string name;  ///< one word for the command line
    std::string says;  ///< a sentence that can be false
    int most_bodies;   ///< about so many in the largest mechanisms
    std::function<Verdict(const Generated&)> of;
};

/// All there are.
const std::vector<Property>& properties();

Verdict accelerations_agree(const Generated& generated);
Verdict methods_converge(const Generated& generated);
Verdict rank_agrees(const Generated& generated);
Verdict kinematics_agree(const Generated& generated);
Verdict assembles_again(const Generated& generated);
Verdict reactions_balance(const Generated& generated);

}  // namespace jw::test
