#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/model/mechanism.hpp"

/// Masses and loads of a mechanism: gravity, forces, torques, springs. Only lessons with dynamics have them.
namespace jw {

/// Mass and inertia of a body.
struct MassProperties {
    double mass = 1.0;                 ///< [kg], > 0
    Vec3 centre_local = Vec3::Zero();  ///< centre of mass in the body frame [m]
    Mat3 J_local = Mat3::Identity();   ///< inertia tensor J' about the centre of mass, axes of the body frame
                                       ///< [kg m²], symmetric positive definite
};

/// Frame of a direction: the global one, or that of the body.
enum class Frame { global, local };

/// Dry friction, made smooth: `size` v / √(v² + speed²) against a rate v. It is 0.71 `size` at `speed` and
/// 0.995 `size` at ten times `speed`. It is zero at rest: a load P below `size` causes the rate
/// speed (P / size) / √(1 - (P / size)²).
struct DryFriction {
    double size = 0.0;   ///< [N], or [N m] about an axis
    double speed = 1.0;  ///< > 0 [m/s], or [rad/s]

    bool operator==(const DryFriction&) const = default;
    double at(double rate) const {
        return size == 0.0 ? 0.0 : size * (rate / std::sqrt(rate * rate + speed * speed));
    }
};

/// Spring and damper between two points: f = k (ℓ - ℓ0) + c ℓ̇ + friction + law, pulling when positive.
/// With an axis, ℓ is the displacement along it (of either sign); f acts along it at the point of body j.
struct Spring {
    int body_i = 0;
    int body_j = 0;
    Vec3 P_i_local = Vec3::Zero();                 ///< [m]
    Vec3 P_j_local = Vec3::Zero();                 ///< [m]
    double stiffness = 0.0;                        ///< k [N/m]
    double free_length = 0.0;                      ///< ℓ0 [m]
    double damping = 0.0;                          ///< c [N s/m]
    std::optional<Vec3> s_i_local = std::nullopt;  ///< unit axis fixed in body i
    DryFriction friction = {};                     ///< against ℓ̇
    std::optional<ScalarFormula> law = {};  ///< added force [N], a function of ℓ [m], ℓ̇ [m/s] and t [s]
};

/// Spring and damper about a joint's axis: torque -k (θ - θ0) - c θ̇ - friction - law from body i on body j.
struct RotationalSpring {
    int body_i = 0;
    int body_j = 0;
    AngleMeasure angle;
    double stiffness = 0.0;     ///< k [N m/rad]
    double free_angle = 0.0;    ///< θ0 [rad]; beyond half a turn it includes turns, see begin_turns
    double damping = 0.0;       ///< c [N m s/rad]
    DryFriction friction = {};  ///< against θ̇
    std::optional<ScalarFormula> law =
        {};  ///< torque against θ [N m], a function of θ with its turns [rad], θ̇ [rad/s] and t [s]
    bool depends_on_angle() const { return stiffness != 0.0 || law || is_read; }

    /// θ - θ0 at the last state of the motion [rad]. Poses determine it up to whole turns only; the turns are
    /// counted from here. `centroidal` starts the count at the start pose.
    double twist_before = 0.0;
    bool is_read = false;  ///< it has no constants: the law of a load reads its angle
};

/// Law of a force or a torque: a formula of the time, of angles and of lengths anywhere in the mechanism,
/// such as that of a motor with a controller.
struct LoadLaw {
    /// An angle or a length. A spring without constants measures it; an angle includes its turns, and starts
    /// within half a turn.
    struct Quantity {
        std::string name;  ///< "hinge.angle"
        std::variant<RotationalSpring, Spring> measured;
    };
    static constexpr std::size_t kMostQuantities = (ScalarFormula::kMostVariables - 1) / 2;

    /// Its variables: t [s], then the value of each quantity [rad or m] and its rate
    ScalarFormula formula;
    std::vector<Quantity> quantities;

    static constexpr int index_of_time = 0;
    static constexpr int index_of(std::size_t quantity, int derivative) {
        return 1 + 2 * static_cast<int>(quantity) + derivative;
    }
};

/// A force on a body: direction times magnitude, at a point fixed in the body.
struct AppliedForce {
    int body = 0;
    Vec3 point_local = Vec3::Zero();  ///< [m]
    Vec3 direction = Vec3::UnitX();   ///< any length, which multiplies the magnitude
    Frame frame = Frame::global;      ///< frame of the direction; local: it turns with the body
    TimeFunction magnitude;           ///< [N]
    std::optional<LoadLaw> law = {};  ///< added to the magnitude [N]
};

/// A torque on a body: direction times magnitude.
struct AppliedTorque {
    int body = 0;
    Vec3 direction = Vec3::UnitZ();
    Frame frame = Frame::global;
    TimeFunction magnitude;           ///< [N m]
    int against = -1;                 ///< body that the opposite torque acts on; -1: none
    std::optional<LoadLaw> law = {};  ///< added to the magnitude [N m]
};

/// A rubber block between two bodies: springs and dampers along and about its three axes, which turn with
/// body i. It adds no equation: it pulls the point of body j back to that of body i, and the axes in body j
/// back to those in body i. Both are the same without load.
///
/// With φ, the rotation vector of the axes in body j against those in body i (angle times axis, up to half a
/// turn), its potential energy is Σ k d²/2 + Σ k_φ φ²/2 over the components of d and φ along its axes.
struct Bushing {
    int body_i = 0;
    int body_j = 0;
    Vec3 P_i_local = Vec3::Zero();             ///< [m]
    Vec3 P_j_local = Vec3::Zero();             ///< [m]
    Mat3 axes_i_local = Mat3::Identity();      ///< columns: its axes x, y, z in body i
    Mat3 axes_j_local = Mat3::Identity();      ///< the same in body j
    Vec3 stiffness = Vec3::Zero();             ///< along x, y, z [N/m]
    Vec3 damping = Vec3::Zero();               ///< [N s/m]
    Vec3 rotational_stiffness = Vec3::Zero();  ///< about x, y, z [N m/rad]
    Vec3 rotational_damping = Vec3::Zero();    ///< [N m s/rad]

    bool operator==(const Bushing&) const = default;
};

/// True if a spring's law depends on the time: then it has no potential energy.
inline bool depends_on_time(const auto& spring) {
    constexpr int index_of_time = 2;
    return spring.law && spring.law->uses(index_of_time);
}

/// True if the spring acts about the axis of the joint, between its bodies, with the same zero angle.
bool acts_about(const RotationalSpring& spring, const Joint& joint);
/// True if the spring acts along the axis of the joint, between its bodies, with the same zero displacement.
bool acts_along(const Spring& spring, const Joint& joint);

/// Masses of the bodies, and the loads on them.
struct Loads {
    std::vector<std::optional<MassProperties>> masses;  ///< one per body of the mechanism
    Vec3 gravity = Vec3::Zero();                        ///< [m/s²]
    std::vector<AppliedForce> forces;
    std::vector<AppliedTorque> torques;
    std::vector<Spring> springs;
    std::vector<RotationalSpring> rotational_springs;
    std::vector<Bushing> bushings;
};

/// Calls `f` with the law of every force and torque that has one.
template <class L, class F>
void for_each_law(L& loads, F&& f) {
    for (auto& force : loads.forces) {
        if (force.law) { f(*force.law); }
    }
    for (auto& torque : loads.torques) {
        if (torque.law) { f(*torque.law); }
    }
}

/// Calls `f` with every spring of type S that measures a quantity of a law.
template <class S, class L, class F>
void for_each_measuring(L& loads, F&& f) {
    for_each_law(loads, [&](auto& law) {
        for (auto& quantity : law.quantities) {
            if (auto* spring = std::get_if<S>(&quantity.measured)) { f(*spring); }
        }
    });
}

/// Calls `f` with every rotational spring, those that measure an angle included.
template <class L, class F>
void for_each_angle(L& loads, F&& f) {
    for (auto& spring : loads.rotational_springs) { f(spring); }
    for_each_measuring<RotationalSpring>(loads, f);
}

/// The loads without dry friction.
Loads without_friction(Loads loads);

/// Mechanism and loads with every body frame moved to the body's centre of mass, where M is block diagonal,
/// diag(m I, J'). Orientations are unchanged.
struct Centroidal {
    Mechanism mechanism;
    Loads loads;  ///< centre_local of all masses is zero

    /// Convert state and motion of the frames as given to those of the centroidal frames, and back.
    State to_centroidal(const State& state) const;
    Motion to_centroidal(const State& state, const Motion& motion) const;
    State as_given(const State& centroidal) const;
    Motion as_given(const State& centroidal, const Motion& motion) const;
    /// Accelerations r̈, ω̇' of the frames as given.
    Motion acceleration_as_given(
        const State& centroidal, const Motion& velocity, const Motion& acceleration) const;

    std::vector<Vec3> centres;  ///< centre of mass of every body in its frame as given [m]
};

/// Mechanism and loads in centroidal frames.
/// @throws std::invalid_argument if a moving body has no mass, or a mass or J' is not positive
Centroidal centroidal(const Mechanism& mechanism, const Loads& loads);

}  // namespace jw
