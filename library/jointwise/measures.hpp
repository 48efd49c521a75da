#pragma once

#include <array>

#include "jointwise/trajectory.hpp"

/// Measurements on a mechanism: quantities by their names, as docs/quantities.md lists them, and
/// reactions.
namespace jointwise {
inline namespace JOINTWISE_ABI {

/// Names of all quantities of a mechanism, except those that need a point or a direction.
std::vector<std::string> quantity_names(const Mechanism& mechanism);

/// Quantities of one mechanism at many moments: the names are read once. Two threads must not use it at the
/// same time.
class Quantities {
public:
    /// @throws std::invalid_argument for a name that is not a quantity
    Quantities(const Mechanism& mechanism, const std::vector<std::string>& names);
    ~Quantities();
    Quantities(Quantities&&) noexcept;
    Quantities& operator=(Quantities&&) noexcept;

    /// Present names; they replace old names that were given.
    const std::vector<std::string>& names() const;
    /// "rad/s", "N m"; "1" for a number without a unit. SI and radians.
    const std::vector<std::string>& units() const;

    /// One value per name; NaN for a quantity without a value. For rotational springs, no whole turns since
    /// the start pose are counted, because a pose does not contain them.
    Eigen::VectorXd at(const Moment& moment) const;
    /// One row per time. Turns of rotational springs are counted from row to row: between two rows, no spring
    /// may turn by half a turn or more. Turns of angles are followed from row to row by their rates.
    Table along(const Trajectory& trajectory) const;

private:
    struct Inside;
    std::unique_ptr<Inside> inside_;
};

/// Force and torque of a joint or driver on its body j; the opposite acts on body i at the same point.
struct Reaction {
    std::string name;  ///< of the joint or driver
    bool of_driver = false;
    int body_i = 0;
    int body_j = 0;
    Vector3 point = Vector3::Zero();   ///< on body j, global [m]
    Vector3 force = Vector3::Zero();   ///< global [N]
    Vector3 torque = Vector3::Zero();  ///< about the point, global [N m]
    /// True if the component along x, y, z is the same in every solution.
    std::array<bool, 3> force_unique{true, true, true};
    std::array<bool, 3> torque_unique{true, true, true};
    double effort = 0.0;  ///< of a driver, along its measure: effort times rate is its power [N, N m]
};

/// Reactions of a motion; if redundant equations leave them undetermined, the smallest ones.
struct Reactions {
    std::vector<Reaction> reactions;  ///< of joints, then of drivers; none between two fixed bodies
    int open = 0;                     ///< independent reactions that can be added without any motion
    /// Part of M q̈ - Q that no reaction explains, relative; if it is above `bound`, the moment does not
    /// belong to a motion.
    double residual = 0.0;
    double bound = 0.0;  ///< bound of the residual from rounding
};
/// @throws std::invalid_argument if a moving body has no mass
Reactions reactions_at(const Mechanism& mechanism, const Moment& moment);

}  // namespace JOINTWISE_ABI
}  // namespace jointwise
