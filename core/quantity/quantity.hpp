#pragma once

#include <array>
#include <string_view>
#include <variant>

#include "core/jets/drivers.hpp"
#include "core/model/joint_types.hpp"

/// Quantities: what can be measured on a mechanism. A quantity is a plain value; names.hpp gives its name,
/// evaluate.hpp its value at an instant.
namespace jw {

/// Unit of a number before any "per second".
enum class Unit { none, metre, radian, joule, newton, newton_metre };

/// A unit divided by a power of seconds: rad/s is {radian, 1}.
struct UnitRate {
    Unit unit = Unit::none;
    int per_s = 0;

    bool operator==(const UnitRate&) const = default;
};

/// "m", "N m"; empty for none.
constexpr std::string_view symbol_of(Unit unit) {
    switch (unit) {
        case Unit::none: return "";
        case Unit::metre: return "m";
        case Unit::radian: return "rad";
        case Unit::joule: return "J";
        case Unit::newton: return "N";
        case Unit::newton_metre: break;
    }
    return "N m";
}

/// "/s²": `count` times "per second", up to three.
constexpr std::string_view per_seconds(int count) {
    constexpr std::array<std::string_view, 4> kWords{"", "/s", "/s²", "/s³"};
    return kWords[static_cast<std::size_t>(count)];
}

/// A measure of drivers.hpp. A SquaredDistanceMeasure stands for the distance itself (its root).
struct MeasureQuantity {
    Measure measure;
    int body_i = 0;
    int body_j = 0;
    int joint = -1;   ///< joint whose measure it is, -1 for none
    int driver = -1;  ///< driver whose distance it is, -1 for none
};

/// One component of the angular velocity of a body.
struct AngularVelocityQuantity {
    int body = 0;
    bool local = false;  ///< ω' instead of ω
    int component = 0;
};

/// One component of r + A s'.
struct PointQuantity {
    int body = 0;
    Vec3 s_local = Vec3::Zero();
    int component = 0;
};

/// Size of the velocity of r + A s'.
struct PointSpeedQuantity {
    int body = 0;
    Vec3 s_local = Vec3::Zero();
};

enum class BodyVector { r, r_dot, r_ddot, omega, omega_dot };
inline constexpr int kBodyVectors = 5;

/// Size of a vector of a body.
struct BodySizeQuantity {
    int body = 0;
    BodyVector vector = BodyVector::r;
};

/// Angle between a direction of one body and a direction of another, in [0, π].
struct DirectionsQuantity {
    int body_i = 0;
    Vec3 a_i_local = Vec3::UnitX();  ///< any length but 0
    int body_j = 0;
    Vec3 a_j_local = Vec3::UnitX();
};

enum class EnergyPart { kinetic, potential, sum };
inline constexpr int kEnergyParts = 3;

struct EnergyQuantity {
    EnergyPart part = EnergyPart::kinetic;
};

enum class WrenchPart { force, torque };

/// Force or torque of a joint or driver on body j; the torque is about the joint's point.
struct ReactionQuantity {
    int joint = -1;   ///< joint; -1: it belongs to the driver
    int driver = -1;  ///< driver; -1: it belongs to the joint
    WrenchPart part = WrenchPart::force;
    int component = 0;  ///< global x, y, z; 3: the magnitude
};

/// Force or torque of a driver along the quantity that it prescribes: effort times rate is its power.
struct EffortQuantity {
    int driver = 0;
    bool is_torque = false;  ///< the driver prescribes an angle
};

/// |p| - 1 of a body.
struct ParameterErrorQuantity {
    int body = 0;
};

/// Φ of one equation divided by its size, as in `residual_below`; also of one that is left out.
struct ResidualQuantity {
    int joint = -1;   ///< joint; -1: it belongs to the driver
    int driver = -1;  ///< driver; -1: it belongs to the joint
    Role role = Role::same_point;
    int component = 0;
};

/// The smallest singular value that counts, of Φq in (r, ω′) in the scene's unit of length.
struct SingularValueQuantity {};

/// Condition of the rows of a joint's p1 or p2 that are in use.
struct PairConditionQuantity {
    int joint = 0;
    Role role = Role::axes_parallel;  ///< axes_parallel (p1) or distance_parallel (p2)
};

using Quantity = std::variant<
    MeasureQuantity, AngularVelocityQuantity, PointQuantity, PointSpeedQuantity, BodySizeQuantity,
    DirectionsQuantity, EnergyQuantity, ReactionQuantity, EffortQuantity, ParameterErrorQuantity,
    ResidualQuantity, SingularValueQuantity, PairConditionQuantity>;

/// Dimension of the quantity itself; its n-th derivative has n more "per second".
UnitRate dimension_of(const Quantity& quantity);

/// Unit of the quantity that a driver prescribes by its measure; a squared distance stands for the distance.
Unit unit_of(const Measure& measure);

/// Number of derivatives that have a meaning and are known: 0, 1 or 2.
int derivatives_of(const Quantity& quantity);

/// True if a pose gives the quantity only up to whole turns.
bool is_modulo_turn(const Quantity& quantity);

/// True for quantities that depend on masses and forces: energies, reactions, efforts.
bool needs_masses(const Quantity& quantity);

/// Joint to which the quantity belongs, -1 for none.
int joint_of(const Quantity& quantity);
/// Driver to which the quantity belongs, -1 for none.
int driver_of(const Quantity& quantity);

}  // namespace jw
