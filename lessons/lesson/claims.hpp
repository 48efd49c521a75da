#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/quantity/quantity.hpp"
#include "lessons/diagnostics/text_place.hpp"
#include "lessons/formula/subject.hpp"
#include "lessons/text/text.hpp"

/// Claims of a lesson about its mechanism, proved by `jointwise check`. An [[expect]] block becomes one
/// Claim for every fact in it.
namespace jw {

/// The state of the file, not assembled; all joints and drivers take part.
struct AsGiven {
    bool operator==(const AsGiven&) const = default;
};
/// After the first `count` entries of Lesson::order have been added and assembled, at the motion's first
/// time.
struct AfterAddition {
    int count = 0;

    bool operator==(const AfterAddition&) const = default;
};
/// During the motion [s].
struct AtTime {
    double t = 0.0;
    bool by_forces = false;  ///< in the motion by masses and forces, not in [motion]

    bool operator==(const AtTime&) const = default;
};
/// In any state of the bodies, assembled or not: what always holds is tested in random states.
struct AnyState {
    bool operator==(const AnyState&) const = default;
};
/// At the equilibrium to which the forces lead from the assembled pose; drivers and loads are those of t = 0.
struct AtRest {
    bool operator==(const AtRest&) const = default;
};
using Moment = std::variant<AsGiven, AfterAddition, AtTime, AnyState, AtRest>;

enum class Count { rank, rows, columns, dof, redundant, mobility_by_counting };

struct CountClaim {
    Count count = Count::rank;
    int value = 0;
};
/// The component of a joint's p1 or p2 that is left out.
struct DroppedClaim {
    int joint = 0;
    Role role = Role::axes_parallel;  ///< axes_parallel (p1) or distance_parallel (p2)
    int component = 0;                ///< 0, 1, 2 = x, y, z
};
enum class Bound { residual_below, condition_below, condition_above };
struct BoundClaim {
    Bound bound = Bound::residual_below;
    double limit = 0.0;
};
enum class Verdict {
    change_point,  ///< the pose is singular: the rank is lower than in poses around it
    closes,        ///< Newton-Raphson finds a pose that satisfies all equations
    stable,        ///< an equilibrium to which small motions return
};
struct VerdictClaim {
    Verdict verdict = Verdict::closes;
    bool value = true;
};
struct QuantityClaim {
    Quantity quantity;
    std::string text;          ///< as the author wrote it, "hinge.angle"
    int derivative = 0;        ///< order of the derivative with respect to time: 0, 1, 2
    int named_derivative = 0;  ///< the part of this order that is in the name: 1 for "hinge.angle_dot"
    bool in_degrees = false;   ///< the author wrote degrees, so messages use them too
    double value = 0.0;        ///< SI, radians
    double tolerance = 0.0;    ///< SI, radians; > 0. Angles are compared modulo a turn, θ of a screw is not
};
/// An equation, whose sides are evaluated and compared.
struct FormulaClaim {
    formula::Formula formula;
    bool holds = true;  ///< false: a misprint, which must not hold
};
using Fact = std::variant<CountClaim, DroppedClaim, BoundClaim, VerdictClaim, QuantityClaim, FormulaClaim>;

struct Claim {
    Moment when;
    Fact fact;
    SourceSpan span;  ///< of the fact's value in the lesson file, for messages
    Text why;
};

}  // namespace jw
