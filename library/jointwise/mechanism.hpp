#pragma once

#include <concepts>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "jointwise/version.hpp"

#if EIGEN_DEFAULT_ALIGN_BYTES != JOINTWISE_EIGEN_ALIGN_BYTES
#error \
    "Jointwise was compiled for other vector instructions than this file, so Eigen allocates memory in another way. Compile this file without -march=native, -mavx and the like, or build Jointwise with the same flags."
#endif

/// Mechanisms: bodies, joints, drivers, masses. SI units and radians; `docs/notation.md` has the symbols.
namespace jointwise {
inline namespace JOINTWISE_ABI {

using Vector3 = Eigen::Vector3d;
using Vector4 = Eigen::Vector4d;  ///< Euler parameters e0, e1, e2, e3
using Matrix3 = Eigen::Matrix3d;

/// A vector or matrix as an argument: any Eigen expression of that size, or the numbers of a vector in
/// braces, {1, 0, 0}. Eigen's own types accept two numbers for any size, and abort at run time. Here they do
/// not compile, and an expression whose size is known only at run time throws std::invalid_argument.
template <int Rows, int Columns = 1>
struct Argument : Eigen::Matrix<double, Rows, Columns> {
    using Value = Eigen::Matrix<double, Rows, Columns>;

    template <class Expression>
    Argument(const Eigen::EigenBase<Expression>& value) : Value(checked(value.derived())) {}
    template <std::convertible_to<double>... Numbers>
    requires(Columns == 1 && sizeof...(Numbers) == Rows) Argument(Numbers... numbers)
        : Value(static_cast<double>(numbers)...) {}

private:
    template <class Expression>
    static const Expression& checked(const Expression& value) {
        if (value.size() == Rows * Columns) { return value; }
        throw std::invalid_argument(
            "jointwise: an argument has " + std::to_string(value.size()) + " numbers; expected " +
            std::to_string(Rows * Columns));
    }
};

/// Position of a joint in the global frame, at the start pose of its bodies. Each type uses a part of it.
struct Place {
    Argument<3> at = Vector3::Zero();       ///< point of the first body [m]
    std::optional<Argument<3>> to = {};     ///< point of the second body [m]; absent: `at`
    Argument<3> axis = Vector3::UnitZ();    ///< of both bodies, any length
    std::optional<Argument<3>> axis2 = {};  ///< of the second body, where it has another
    std::optional<Argument<3>> side = {};   ///< perpendicular to the axis: where angles begin; absent: any
    std::optional<double> pitch = {};       ///< a screw needs it: advance in one turn [m], left-hand below 0
    std::optional<double> ratio =
        {};  ///< a gear or a belt needs it: turns of the second wheel in one of the first
    std::vector<Vector3> curve =
        {};  ///< a curve needs it: points in the frame of the first body, from `at` on [m]
    std::optional<double> radius =
        {};  ///< a rack needs it [m]; below 0: moves along when it turns left-handed
};

/// Prescribed value of a driver [rad or m]: c0 + c1 t + c2 t² + ...
using Polynomial = std::vector<double>;

/// A mechanism as data; it can be copied. Numbers of bodies and joints count from 0; body 0 is the ground,
/// which does not move. Every function throws std::invalid_argument for an invalid argument, and leaves the
/// mechanism unchanged.
class Mechanism {
public:
    Mechanism();
    /// Copies share their data until one of them is changed.
    Mechanism(const Mechanism&) = default;
    Mechanism& operator=(const Mechanism&) = default;

    /// Adds a moving body at its start estimate. @return its number
    int add_body(const std::string& name, const Argument<3>& r, const Argument<4>& p = Vector4::Unit(0));
    /// Adds a joint; `joint_types()` lists the types. @return its number
    int add_joint(
        const std::string& name, const std::string& type, int body_i, int body_j, const Place& place);
    /// Prescribes the angle of a joint [rad] or, if it has none, its displacement [m], as a function of time.
    int add_driver(const std::string& name, int joint, const Polynomial& value);

    /// Velocities of a body at the start: of its origin, and its angular velocity in its own frame.
    void set_velocity(int body, const Argument<3>& r_dot, const Argument<3>& omega_local);
    /// Mass [kg], inertia tensor about the centre of mass in axes of the body [kg m²], centre in its frame
    /// [m].
    void set_mass(
        int body, double mass, const Argument<3, 3>& J_local,
        const Argument<3>& centre_local = Vector3::Zero());
    void set_gravity(const Argument<3>& g);  ///< [m/s²]
    /// Spring and damper between two points in the frames of their bodies: f = k (l - free_length) + c dl/dt.
    void add_spring(
        int body_i, const Argument<3>& P_i_local, int body_j, const Argument<3>& P_j_local, double k,
        double free_length, double c = 0.0);

    std::vector<std::string> body_names() const;
    std::vector<std::string> joint_names() const;
    std::vector<std::string> driver_names() const;

    struct Inside;  ///< only for the library
    const Inside& inside() const { return *inside_; }
    explicit Mechanism(const Inside& inside);

private:
    Inside& own();

    std::shared_ptr<Inside> inside_;
};

/// Names of the joint types that `add_joint` takes: all but "formula", whose equation is text in a lesson.
std::vector<std::string> joint_types();

}  // namespace JOINTWISE_ABI
}  // namespace jointwise
