#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "core/jets/primitives.hpp"

/// The joint library: a joint is an entry of a table, made of primitives. Parser, palette, docs and tests
/// iterate over `kJointTypes`.
namespace jw {

/// A primitive together with the vectors of the joint's geometry that it uses.
enum class Role {
    same_point,                ///< s(P)
    axes_parallel,             ///< p1(s)
    distance_parallel,         ///< p2(s_i, d)
    axes_perpendicular,        ///< n1(s)
    distance_perpendicular,    ///< n2(s_i, d)
    distance_perpendicular_j,  ///< n2(s_j, d)
    sides_perpendicular,       ///< n1(h), h perpendicular to the axis
    length,                    ///< d·d = L²
    formula,                   ///< an equation that the author wrote
    screw_advance,             ///< r of slide 11
    screw_angle,               ///< θ of slide 11
    wheel_i,                   ///< θ, from the line of centres to u_i
    wheel_j,                   ///< ratio θ, from the line of centres to u_j
    bevel_i,                   ///< θ, from the common normal of the axes to u_i
    bevel_j,                   ///< ratio θ, from the common normal to u_j
    rack_advance,              ///< r of slide 11 along a rack
    rack_angle,                ///< θ, from the direction of the rack to u_j
    curve_x,                   ///< x of a point equals x of the curve, in the frame of the curve's body
    curve_y,
    curve_z,
};

/// Vectors of a joint's geometry, one bit each.
enum Vectors : unsigned {
    kPoints = 1U << 0U,  ///< P_i and P_j, which coincide
    kD = 1U << 1U,       ///< d from P_i to P_j
    kAxisI = 1U << 2U,   ///< s_i
    kAxisJ = 1U << 3U,   ///< s_j
    kSidesH = 1U << 4U,  ///< h_i and h_j
    kSidesU = 1U << 5U,  ///< u_i and u_j
};

/// Dimension of Φ for unit axes: a number, a length [m] or its square [m²].
enum class Dimension { none, length, square, of_author };

/// Name and parts of the equations of a role.
struct RoleTraits {
    Role role;
    std::string_view name;  ///< shown beside the rows of a joint; unique within a joint
    int independent;        ///< equations that can be independent: two of the three of p1 and p2
    unsigned vectors;       ///< bits of Vectors
    Dimension dimension;
    std::string_view pair_name = {};  ///< name in the form ParallelForm::pair
};

inline constexpr std::array kRoles{
    RoleTraits{Role::same_point, "s", 3, kPoints, Dimension::length},
    RoleTraits{Role::axes_parallel, "p1", 2, kAxisI | kAxisJ, Dimension::none, "n1 pair"},
    RoleTraits{Role::distance_parallel, "p2", 2, kAxisI | kD, Dimension::length, "n2 pair"},
    RoleTraits{Role::axes_perpendicular, "n1", 1, kAxisI | kAxisJ, Dimension::none},
    RoleTraits{Role::distance_perpendicular, "n2", 1, kAxisI | kD, Dimension::length},
    RoleTraits{Role::distance_perpendicular_j, "n2 j", 1, kAxisJ | kD, Dimension::length},
    RoleTraits{Role::sides_perpendicular, "n1", 1, kSidesH, Dimension::none},
    RoleTraits{Role::length, "d", 1, kD, Dimension::square},
    RoleTraits{Role::formula, "f", 1, kD | kAxisI | kAxisJ | kSidesU, Dimension::of_author},
    RoleTraits{Role::screw_advance, "r", 1, kAxisI | kD, Dimension::length},
    RoleTraits{Role::screw_angle, "θ", 1, kAxisI | kSidesU, Dimension::none},
    RoleTraits{Role::wheel_i, "θ i", 1, kAxisI | kSidesU | kD, Dimension::length},
    RoleTraits{Role::wheel_j, "θ j", 1, kAxisJ | kSidesU | kD, Dimension::length},
    RoleTraits{Role::bevel_i, "θ i", 1, kAxisI | kAxisJ | kSidesU, Dimension::none},
    RoleTraits{Role::bevel_j, "θ j", 1, kAxisI | kAxisJ | kSidesU, Dimension::none},
    RoleTraits{Role::rack_advance, "r", 1, kAxisI | kD, Dimension::length},
    RoleTraits{Role::rack_angle, "θ", 1, kAxisI | kAxisJ | kSidesU, Dimension::none},
    RoleTraits{Role::curve_x, "c x", 1, kD, Dimension::length},
    RoleTraits{Role::curve_y, "c y", 1, kD, Dimension::length},
    RoleTraits{Role::curve_z, "c z", 1, kD, Dimension::length},
};

constexpr const RoleTraits& traits_of(Role role) { return kRoles[static_cast<std::size_t>(role)]; }
static_assert(
    std::ranges::all_of(kRoles, [](const RoleTraits& r) { return &traits_of(r.role) == &r; }),
    "kRoles is in the order of Role");

/// True if the equations of the role contain the joint's artificial coordinate.
constexpr bool has_theta(Role role) { return role >= Role::screw_advance; }

/// True if θ is the angle of the wheel of the role.
constexpr bool is_first_wheel(Role role) {
    return role == Role::wheel_i || role == Role::bevel_i || role == Role::rack_angle;
}
/// True if the wheel of the role follows θ.
constexpr bool is_second_wheel(Role role) { return role == Role::wheel_j || role == Role::bevel_j; }

constexpr bool is_parallel(Role role) { return traits_of(role).independent == 2; }

/// Vectors of a joint in its two bodies. Which of them matter depends on the type's primitives.
struct JointGeometry {
    Vec3 P_i_local = Vec3::Zero();  ///< attachment point, the P of s and the B of n2 and p2 [m]
    Vec3 P_j_local = Vec3::Zero();
    Vec3 s_i_local = Vec3::UnitZ();  ///< axis
    Vec3 s_j_local = Vec3::UnitZ();
    Vec3 h_i_local = Vec3::UnitX();  ///< side vector, perpendicular to the axis
    Vec3 h_j_local = Vec3::UnitY();
    /// The angle about the axis is measured from u_i to u_j (unit, perpendicular to the axis; the u of
    /// slide 11); u_i = u_j at the start pose when the joint was given by a global axis. Both u of two wheels
    /// lie on the line of the wheels at the same time.
    Vec3 u_i_local = Vec3::UnitX();
    Vec3 u_j_local = Vec3::UnitX();
    double length = 0.0;    ///< [m]
    ScalarFormula formula;  ///< Φ of a formula joint, a function of the components of FormulaVector
    /// Points of r_i and r_j in a formula [m]: not 0 if the frames were moved to the centres of mass.
    Vec3 O_i_local = Vec3::Zero();
    Vec3 O_j_local = Vec3::Zero();
    double alpha = 0.0;    ///< screw: advance per radian [m/rad]; rack: the radius of its wheel
    double d_0 = 0.0;      ///< screw and rack [m]
    double theta_0 = 0.0;  ///< screw and rack [rad]
    double ratio = 0.0;    ///< gear and belt: turns of wheel j per turn of wheel i, from the line of centres
    /// Radii of gear and belt, if given [m]; negative in j: the inner side of a ring, or a crossed belt.
    std::array<double, 2> radii{};
    Curve curve;  ///< in the axes of body i, measured from P_i
    ScrewAngleForm screw_angle_form = ScrewAngleForm::rotation;
    /// Start estimate of the artificial coordinate and its rate; absent: measured at the start pose.
    std::optional<double> theta_start;      ///< [rad]
    std::optional<double> theta_dot_start;  ///< [rad/s]
    /// Rates of the joint's angle and displacement when dynamics starts; absent: any that the bodies have.
    std::optional<double> angle_dot_start;         ///< [rad/s]
    std::optional<double> displacement_dot_start;  ///< [m/s]

    bool operator==(const JointGeometry&) const = default;
};

/// Part of the motion that a joint allows; parts are in order from the carrying body to the carried one.
enum class Freedom {
    turn,             ///< about the axis of the carried body
    turn_of_carrier,  ///< about the axis of the carrying body
    slide,            ///< along the axis
    slide_across,     ///< along the first of two directions across the axis
    slide_upright,    ///< along the second of them
    screw,            ///< about the axis and along it, by α
    ball,             ///< any turn about the point: three freedoms
};
constexpr int freedoms_of(Freedom freedom) { return freedom == Freedom::ball ? 3 : 1; }

/// Glyph of a joint; `none` shows its vectors only.
enum class JointGlyph {
    none,
    pin,
    ball,
    cross,
    sleeve,
    slide,
    thread,
    block,
    plate,
    rod,
    rod_from_pin_to_ball,
    rod_between_pins,
    rod_from_cross_to_ball,
    bead_on_bar,
    bead_on_plate,
    gear,
    bevel,
    belt,
    rack,
    bead_on_curve,
};

/// Everything that the program knows of a joint: nothing else depends on its name.
struct JointType {
    std::string_view name;
    std::span<const Role> roles;
    int dof;                          ///< relative freedoms of the two bodies
    std::span<const Freedom> motion;  ///< these freedoms as a chain of simple ones; empty if there is none
    int artificial;                   ///< artificial coordinates that it adds
    JointGlyph glyph;
    std::string_view source;

    constexpr int independent_rows() const {
        int rows = 0;
        for (const Role role : roles) { rows += traits_of(role).independent; }
        return rows;
    }
    constexpr bool uses(Role role) const { return std::ranges::find(roles, role) != roles.end(); }
    constexpr bool uses(Vectors vectors) const {
        return std::ranges::any_of(roles, [&](Role r) { return (traits_of(r).vectors & vectors) != 0; });
    }
    /// True if the angle about the axis is free: it can be driven, claimed and plotted. Sides set its zero.
    constexpr bool has_angle() const { return uses(Role::axes_parallel) && !uses(Role::sides_perpendicular); }
    /// True if its sides are the u from which an angle is measured, not the h of an n1.
    constexpr bool has_marks() const { return has_angle() || uses(kSidesU); }
    /// True if the author writes its equation; then all vectors are optional.
    constexpr bool has_formula() const { return uses(Role::formula); }
    constexpr bool has_curve() const { return uses(Role::curve_x); }
    /// True if its artificial coordinate is that of a wheel or of a curve, not an angle about its axis.
    constexpr bool has_own_coordinate() const { return artificial > 0 && !has_angle(); }
    /// True if the displacement along the axis is free.
    constexpr bool has_displacement() const { return uses(Role::distance_parallel); }
    /// True if its points keep a distance.
    constexpr bool has_distance() const { return uses(Role::length); }
    /// True if a body can hang from another by it in a tree of joints: `motion` has all its freedoms.
    constexpr bool can_carry() const {
        int freedoms = 0;
        for (const Freedom freedom : motion) { freedoms += freedoms_of(freedom); }
        return freedoms == dof;
    }
};

namespace roles {
inline constexpr std::array spherical{Role::same_point};
inline constexpr std::array universal{Role::same_point, Role::axes_perpendicular};
inline constexpr std::array revolute{Role::same_point, Role::axes_parallel};
inline constexpr std::array cylindrical{Role::axes_parallel, Role::distance_parallel};
inline constexpr std::array prismatic{
    Role::axes_parallel, Role::distance_parallel, Role::sides_perpendicular};
inline constexpr std::array screw{
    Role::axes_parallel, Role::distance_parallel, Role::screw_advance, Role::screw_angle};
inline constexpr std::array fixed{Role::same_point, Role::axes_parallel, Role::sides_perpendicular};
inline constexpr std::array planar{Role::axes_parallel, Role::distance_perpendicular};
inline constexpr std::array distance{Role::length};
inline constexpr std::array formula{Role::formula};
inline constexpr std::array n1{Role::axes_perpendicular};
inline constexpr std::array n2{Role::distance_perpendicular};
inline constexpr std::array p1{Role::axes_parallel};
inline constexpr std::array p2{Role::distance_parallel};
inline constexpr std::array revolute_spherical{Role::distance_perpendicular, Role::length};
inline constexpr std::array revolute_revolute{
    Role::axes_parallel, Role::distance_perpendicular, Role::length};
inline constexpr std::array gear{Role::wheel_i, Role::wheel_j};
inline constexpr std::array bevel{Role::bevel_i, Role::bevel_j};
inline constexpr std::array rack{Role::rack_advance, Role::rack_angle};
inline constexpr std::array curve{Role::curve_x, Role::curve_y, Role::curve_z};
inline constexpr std::array revolute_revolute_crossed{
    Role::axes_perpendicular, Role::distance_perpendicular, Role::distance_perpendicular_j, Role::length};
}  // namespace roles

namespace motions {
inline constexpr std::array<Freedom, 0> none{};
inline constexpr std::array spherical{Freedom::ball};
inline constexpr std::array universal{Freedom::turn_of_carrier, Freedom::turn};
inline constexpr std::array revolute{Freedom::turn};
inline constexpr std::array cylindrical{Freedom::slide, Freedom::turn};
inline constexpr std::array prismatic{Freedom::slide};
inline constexpr std::array screw{Freedom::screw};
inline constexpr std::array planar{Freedom::slide_across, Freedom::slide_upright, Freedom::turn};
}  // namespace motions

// clang-format off
inline constexpr std::array kJointTypes{
    //        name           roles               dof motion         artificial glyph          source
    JointType{"spherical", roles::spherical, 3, motions::spherical, 0, JointGlyph::ball, "slide 6"},
    JointType{"universal", roles::universal, 2, motions::universal, 0, JointGlyph::cross, "slide 7"},
    JointType{"revolute", roles::revolute, 1, motions::revolute, 0, JointGlyph::pin, "slide 8"},
    JointType{"cylindrical", roles::cylindrical, 2, motions::cylindrical, 0, JointGlyph::sleeve, "slide 9"},
    JointType{"prismatic", roles::prismatic, 1, motions::prismatic, 0, JointGlyph::slide, "slide 10"},
    JointType{"screw", roles::screw, 1, motions::screw, 1, JointGlyph::thread, "slide 11"},
    JointType{"fixed", roles::fixed, 0, motions::none, 0, JointGlyph::block, "weld: s, p1, n1"},
    JointType{"planar", roles::planar, 3, motions::planar, 0, JointGlyph::plate, "p1, n2"},
    JointType{"distance", roles::distance, 5, motions::none, 0, JointGlyph::rod,
              "book ch. 7, spherical-spherical"},
    JointType{"formula", roles::formula, 5, motions::none, 0, JointGlyph::none, "an equation of your own"},
    JointType{"n1", roles::n1, 5, motions::none, 0, JointGlyph::none, "slide 2"},
    JointType{"n2", roles::n2, 5, motions::none, 0, JointGlyph::none, "slide 2"},
    JointType{"p1", roles::p1, 4, motions::none, 0, JointGlyph::none, "slide 3"},
    JointType{"p2", roles::p2, 4, motions::none, 0, JointGlyph::none, "slide 3"},
    JointType{"s", roles::spherical, 3, motions::spherical, 0, JointGlyph::none, "slide 6"},
    // links without mass, between joints at their two ends (book ch. 7, composite joints)
    JointType{"revolute-spherical", roles::revolute_spherical, 4, motions::none, 0,
              JointGlyph::rod_from_pin_to_ball, "book ch. 7, composite"},
    JointType{"revolute-revolute", roles::revolute_revolute, 2, motions::none, 0,
              JointGlyph::rod_between_pins, "book ch. 7, composite, parallel axes"},
    JointType{"revolute-revolute-crossed", roles::revolute_revolute_crossed, 2, motions::none, 0,
              JointGlyph::rod_between_pins, "book ch. 7, composite, crossed axes"},
    JointType{"universal-spherical", roles::distance, 5, motions::none, 0,
              JointGlyph::rod_from_cross_to_ball, "book ch. 7, composite"},
    JointType{"point-on-line", roles::p2, 4, motions::none, 0, JointGlyph::bead_on_bar, "slide 3; book ch. 7"},
    JointType{"point-in-plane", roles::n2, 5, motions::none, 0, JointGlyph::bead_on_plate, "slide 2; book ch. 7"},
    // wheels that roll on each other, on a belt or on a rack; other joints constrain their axes
    JointType{"gear", roles::gear, 5, motions::none, 1, JointGlyph::gear, "slide 11, parallel axes"},
    JointType{"bevel-gear", roles::bevel, 5, motions::none, 1, JointGlyph::bevel, "slide 11, crossed axes"},
    JointType{"belt", roles::gear, 5, motions::none, 1, JointGlyph::belt, "slide 11, parallel axes"},
    JointType{"rack", roles::rack, 5, motions::none, 1, JointGlyph::rack, "slide 11"},
    JointType{"curve", roles::curve, 4, motions::none, 1, JointGlyph::bead_on_curve, "slides 6, 11"},
};
// clang-format on

static_assert(
    std::ranges::all_of(
        kJointTypes, [](const JointType& t) { return t.independent_rows() + t.dof == 6 + t.artificial; }),
    "a joint removes as many freedoms as it has independent equations beyond its artificial coordinates");
static_assert(
    std::ranges::all_of(kJointTypes, [](const JointType& t) { return t.motion.empty() || t.can_carry(); }),
    "the motion of a joint is all that it leaves free");

/// The type of that name, or nullptr.
inline const JointType* find_joint_type(std::string_view name) {
    const auto* found = std::ranges::find(kJointTypes, name, &JointType::name);
    return found == kJointTypes.end() ? nullptr : found;
}

/// Form of p1 and p2 of a joint.
enum class ParallelForm {
    rule,    ///< two of three, by the rule of slide 5 with hysteresis
    drop_x,  ///< two of three, the x equation left out for every axis
    drop_y,
    drop_z,
    all_three,  ///< all three kept; one is redundant
    pair,       ///< two n1 (n2) rows with vectors perpendicular to s_i instead
};

/// The primitive of `role` for a joint of this geometry; `form` matters only for p1 and p2.
Primitive primitive_of(Role role, const JointGeometry& geometry, ParallelForm form);

}  // namespace jw
