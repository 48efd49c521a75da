#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "core/primitives.hpp"

/// The joint library: a joint is an entry of a table, made of primitives. Parser, palette, docs and tests
/// iterate over `kJointTypes`.
namespace jw {

/// A primitive together with the vectors of the joint's geometry that it uses.
enum class Role {
    same_point,              ///< s(P)
    axes_parallel,           ///< p1(s)
    distance_parallel,       ///< p2(s, d)
    axes_perpendicular,      ///< n1(s)
    distance_perpendicular,  ///< n2(s, d)
    sides_perpendicular,     ///< n1(h), h perpendicular to the axis
    length,                  ///< d·d = L²
    screw_advance,           ///< r of slide 11
    screw_angle,             ///< θ of slide 11
};

/// Equations of a role that can be independent: two of the three of p1 and p2.
constexpr int independent_equations(Role role) {
    switch (role) {
        case Role::same_point: return 3;
        case Role::axes_parallel:
        case Role::distance_parallel: return 2;
        default: return 1;
    }
}

constexpr bool is_parallel(Role role) {
    return role == Role::axes_parallel || role == Role::distance_parallel;
}

/// Vectors of a joint in its two bodies. Which of them matter depends on the type's primitives.
struct JointGeometry {
    Vec3 P_i_local = Vec3::Zero();  ///< attachment point, the P of s and the B of n2 and p2 [m]
    Vec3 P_j_local = Vec3::Zero();
    Vec3 s_i_local = Vec3::UnitZ();  ///< axis
    Vec3 s_j_local = Vec3::UnitZ();
    Vec3 h_i_local = Vec3::UnitX();  ///< side vector, perpendicular to the axis
    Vec3 h_j_local = Vec3::UnitY();
    /// The angle about the axis is measured from u_i to u_j (unit, perpendicular to the axis; the u of
    /// slide 11); u_i = u_j at the start pose when the joint was given by a global axis.
    Vec3 u_i_local = Vec3::UnitX();
    Vec3 u_j_local = Vec3::UnitX();
    double length = 0.0;   ///< [m]
    double alpha = 0.0;    ///< screw: advance per radian [m/rad]
    double d_0 = 0.0;      ///< screw [m]
    double theta_0 = 0.0;  ///< screw [rad]
    ScrewAngleForm screw_angle_form = ScrewAngleForm::rotation;
    /// Screw, start estimate of the artificial coordinate and its rate; absent: measured from u_i to u_j.
    std::optional<double> theta_start;      ///< [rad]
    std::optional<double> theta_dot_start;  ///< [rad/s]

    bool operator==(const JointGeometry&) const = default;
};

struct JointType {
    std::string_view name;
    std::span<const Role> roles;
    int dof;         ///< relative freedoms of the two bodies
    int artificial;  ///< artificial coordinates it brings along
    std::string_view source;

    constexpr int independent_rows() const {
        int rows = 0;
        for (const Role role : roles) { rows += independent_equations(role); }
        return rows;
    }
    constexpr bool uses(Role role) const { return std::ranges::find(roles, role) != roles.end(); }
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
inline constexpr std::array n1{Role::axes_perpendicular};
inline constexpr std::array n2{Role::distance_perpendicular};
inline constexpr std::array p1{Role::axes_parallel};
inline constexpr std::array p2{Role::distance_parallel};
}  // namespace roles

inline constexpr std::array kJointTypes{
    //        name           roles               dof artificial source
    JointType{"spherical", roles::spherical, 3, 0, "slide 6"},
    JointType{"universal", roles::universal, 2, 0, "slide 7"},
    JointType{"revolute", roles::revolute, 1, 0, "slide 8"},
    JointType{"cylindrical", roles::cylindrical, 2, 0, "slide 9"},
    JointType{"prismatic", roles::prismatic, 1, 0, "slide 10"},
    JointType{"screw", roles::screw, 1, 1, "slide 11"},
    JointType{"fixed", roles::fixed, 0, 0, "weld: s, p1, n1"},
    JointType{"planar", roles::planar, 3, 0, "p1, n2"},
    JointType{"distance", roles::distance, 5, 0, "book ch. 7, spherical-spherical"},
    JointType{"n1", roles::n1, 5, 0, "slide 2"},
    JointType{"n2", roles::n2, 5, 0, "slide 2"},
    JointType{"p1", roles::p1, 4, 0, "slide 3"},
    JointType{"p2", roles::p2, 4, 0, "slide 3"},
    JointType{"s", roles::spherical, 3, 0, "slide 6"},
};

static_assert(
    std::ranges::all_of(
        kJointTypes, [](const JointType& t) { return t.independent_rows() + t.dof == 6 + t.artificial; }),
    "a joint removes as many freedoms as it has independent equations beyond its artificial coordinates");

/// The type of that name, or nullptr.
inline const JointType* find_joint_type(std::string_view name) {
    const auto* found = std::ranges::find(kJointTypes, name, &JointType::name);
    return found == kJointTypes.end() ? nullptr : found;
}

/// Which form p1 and p2 of a joint take.
enum class ParallelForm {
    rule,    ///< two of three, by the rule of slide 5 with hysteresis
    drop_x,  ///< two of three, the x equation dropped whatever the axis does
    drop_y,
    drop_z,
    all_three,  ///< all three kept; one is redundant
    pair,       ///< two n1 (n2) rows with vectors perpendicular to s_i instead
};

/// The primitive of `role` for a joint of this geometry; `form` matters to p1 and p2 only.
Primitive primitive_of(Role role, const JointGeometry& geometry, ParallelForm form);

}  // namespace jw
