#include "tests/soak/property.hpp"

namespace jw::test {

const std::vector<Property>& properties() {
    static const std::vector<Property> all{
        {"accelerations",
         "Accelerations are the same in joint coordinates, in block equations, in all four dense coordinate "
         "choices and in the long double reference.",
         9, accelerations_agree},
        {"motions", "Every method converges to the motion that the long double reference finds.", 4,
         methods_converge},
        {"rank", "The rank of the Jacobian is that of a rank-revealing QR in long double.", 9, rank_agrees},
        {"jacobian",
         "Every entry of the Jacobian is a difference quotient of Φ in long double, in all four coordinate "
         "choices.",
         6, jacobians_agree},
        {"spectrum",
         "Singular values of the Jacobian are those of a Jacobi method in long double, and decided ranks "
         "hold "
         "next to singular poses.",
         9, spectra_agree},
        {"kinematics",
         "Where drivers leave nothing open, velocity and acceleration analysis give what the long double "
         "reference gives.",
         6, kinematics_agree},
        {"assembly", "Bodies that are pushed off their place by a hundredth come back onto the constraints.",
         6, assembles_again},
        {"reactions", "Reactions and loads together move every body as Newton and Euler say.", 6,
         reactions_balance},
        {"energy",
         "What forces, springs, dampers and drivers put in is what the bodies take up, at the start and "
         "along "
         "a short motion.",
         6, power_balances},
        {"momentum",
         "Where nothing outside acts on the bodies, momentum and angular momentum stay what they are.", 5,
         momentum_stays, afloat},
        {"transformed",
         "A mechanism that is turned, mirrored, longer, heavier or slower has the same rank and "
         "accelerations, "
         "turned, mirrored, longer and slower.",
         6, answers_transform},
        {"reversed", "A motion that is played backwards comes back to where it began.", 4, comes_back,
         without_rows_by_hand},
        {"driven",
         "Where all that the joints of a tree leave free is driven, the pose of every body is the product of "
         "the motions of its joints, in every method.",
         6, joints_multiply, driven_tree},
    };
    return all;
}

}  // namespace jw::test
