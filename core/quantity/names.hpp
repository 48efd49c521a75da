#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/mechanism.hpp"
#include "core/quantity/quantity.hpp"

/// Names of quantities: "crank.x", "hinge.angle_dot", "energy.sum". They are the same everywhere: in claims,
/// columns of tables and curves. docs/quantities.md lists them.
namespace jw {

/// A quantity, or a derivative of it: what a name stands for.
struct NamedQuantity {
    Quantity quantity;
    int derivative = 0;
};

/// @param derivative 0 to derivatives_of(quantity)
std::string name_of(const Quantity& quantity, int derivative, const Mechanism& mechanism);

struct ReadName {
    NamedQuantity named;
    /// Present name, if `text` is a former one; otherwise empty.
    std::string name_of_today;
    /// True if the name does not give the point of a body: "crank.point.x".
    bool wants_point = false;
};

/// Finds the quantity of a name, former names included; nothing if there is no such quantity.
std::optional<ReadName> read_name(std::string_view text, const Mechanism& mechanism);

/// Owner in a name: the text up to the first dot, without a bar.
std::string_view owner_in(std::string_view name);

/// Every quantity of a mechanism with all its derivatives, except those that need points or directions.
std::vector<NamedQuantity> quantities_of(const Mechanism& mechanism);
/// Quantities of one body, joint or driver: everything that can follow its name.
std::vector<NamedQuantity> quantities_of_body(int body);
std::vector<NamedQuantity> quantities_of_joint(const Mechanism& mechanism, int joint);
std::vector<NamedQuantity> quantities_of_driver(const Mechanism& mechanism, int driver);

/// All measures of a joint: its angle, its displacement, its distance.
std::vector<MeasureQuantity> measures_of(const Mechanism& mechanism, int joint);
/// Quantity that a driver prescribes.
MeasureQuantity measure_of_driver(const Mechanism& mechanism, int driver);

/// "s", "p1", "theta": the equation of a role in names, as in `without` of a lesson.
std::string_view word_of(Role role);
/// "x" of three equations, "a" of a pair, nothing for a single equation.
std::string_view component_word(const Joint& joint, Role role, int component);
/// Number of equations of a role in this joint.
int equations_of(const Joint& joint, Role role);

}  // namespace jw
