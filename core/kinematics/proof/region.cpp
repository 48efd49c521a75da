#include <algorithm>

#include "core/kinematics/proof/proved_part.hpp"

/// Choice of the region around an anchor. It decides which steps can be proved, not whether a proof is right.
namespace jw {

namespace {

constexpr double kSmaller = 0.25;
constexpr double kLeastReach = 1e-5;  // a tube of rounding must still fit in

/// Change of M J per unit of distance from the anchor.
double change_of_jacobian(const Anchor& anchor) {
    MatrixX change = MatrixX::Zero(anchor.inverse.rows(), anchor.inverse.rows());
    for (const Curvature& c : anchor.curvatures) {
        if (c.of < change.cols()) { change.col(c.of) += c.bound * anchor.inverse.col(c.equation); }
    }
    return change.rowwise().sum().maxCoeff();
}

}  // namespace

bool ProvedPart::has_formula() const {
    return std::ranges::any_of(part_.equations, [&](int e) {
        return std::holds_alternative<FormulaEquation>(step_->equations()[at(e)].primitive);
    });
}

/// Takes the region in which a step can be longest. Bounds of a formula grow with the region, and where it
/// contains a pole there are none.
void ProvedPart::choose_reach(const StepEnd& end, Anchor& anchor) const {
    double best = 1.0;
    double longest = 0.0;
    for (double reach = 1.0; reach > kLeastReach; reach *= kSmaller) {
        anchor.reach = reach;
        bound_derivatives(end, anchor);
        const double region = kReachOfLength * reach;
        // nothing contracts where the change is 1; NaN, where there are no bounds, is never longer
        const double usable = std::min(1.0 / change_of_jacobian(anchor), region);
        if (usable > longest) {
            longest = usable;
            best = reach;
        }
        if (usable == region) { break; }
    }
    anchor.reach = best;
    bound_derivatives(end, anchor);
    measure(anchor);
}

}  // namespace jw
