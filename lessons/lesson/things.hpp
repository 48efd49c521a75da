#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/mechanism.hpp"

/// Short names of a joint's equations, the same in lessons and beside the rows of a matrix: "s x", "p1 y",
/// "θ". Things of a scene that somebody can point at, and their names: "crank", "hinge", "hinge s_i", "hinge
/// p1 y".
namespace jw {

struct Lesson;

/// "s", "p1", "n1 pair", "θ".
std::string primitive_name(Role role, ParallelForm form);
/// "x"; "a" or "b" of a pair, empty for a primitive of one equation.
std::string component_name(int equations, int component);

struct LabelledEquation {
    std::string label;  ///< primitive and component, "p1 y"
    EquationOut equation;
};
/// All equations of a joint in this form, in the order of its primitives, also those that are left out.
std::vector<LabelledEquation> equations_of(const JointType& type, ParallelForm form);

struct Thing {
    enum class Kind { body, joint, vector, row };
    static constexpr int kVectorI = 0;  ///< fixed in body i, "s_i"
    static constexpr int kVectorJ = 1;  ///< fixed in body j, "s_j"
    static constexpr int kVectorD = 2;  ///< between the two, "d"

    Kind kind = Kind::body;
    int index = 0;           ///< of the body, of the joint, or of the driver that a row belongs to
    int part = 0;            ///< of a vector: kVectorI, kVectorJ, kVectorD
    bool driven = false;     ///< of a row: it belongs to a driver
    EquationOut equation{};  ///< of a row of a joint

    bool operator==(const Thing&) const = default;

    static Thing body(int index) { return {Kind::body, index}; }
    static Thing joint(int index) { return {Kind::joint, index}; }
    static Thing vector(int joint, int part) { return {Kind::vector, joint, part}; }
    static Thing row(int joint, EquationOut equation) { return {Kind::row, joint, 0, false, equation}; }
    static Thing row_of_driver(int driver) { return {Kind::row, driver, 0, true}; }
};

/// True if the formula of a joint contains one of these vectors.
bool contains_any(const ScalarFormula& formula, std::initializer_list<FormulaVector> vectors);
/// True if the equations of this role of a joint are made of the vector `part`.
bool is_made_of(const Joint& joint, Role role, int part);

/// All things of a kind, in the order of the mechanism; equations that are left out are rows, too.
std::vector<Thing> things_of(const Mechanism& mechanism, Thing::Kind kind);
std::string name_of(const Thing& thing, const Mechanism& mechanism);
/// The thing of that kind with that name, with any blanks around its words.
std::optional<Thing> thing_named(const Mechanism& mechanism, Thing::Kind kind, std::string_view name);

/// False for a thing of a joint or driver that was taken out of the lesson.
bool is_present(const Thing& thing, const Lesson& lesson);

}  // namespace jw
