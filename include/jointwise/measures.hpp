#pragma once

#include <array>

#include "jointwise/trajectory.hpp"

/// Measurements on a mechanism: quantities by their names, as docs/quantities.md lists them, and
/// reactions.
namespace jointwise {
inline namespace JOINTWISE_ABI {

/// The names of all quantities of a mechanism, but those that need a point or a direction.
std::vector<std::string> quantity_names(const Mechanism& mechanism);

/// Quantities of one mechanism at many moments: the names are read once. Not to be used by two threads at
/// once.
class Quantities {
public:
    /// @throws std::invalid_argument for a name that stands for nothing
    Quantities(const Mechanism& mechanism, const std::vector<std::string>& names);
    ~Quantities();
    Quantities(Quantities&&) noexcept;
    Quantities& operator=(Quantities&&) noexcept;

    /// As they are called today, where a name of before was given.
    const std::vector<std::string>& names() const;
    /// "rad/s", "N m"; "1" where a number has no unit. SI and radians.
    const std::vector<std::string>& units() const;

    /// One value per name; NaN where a quantity has no value. Rotational springs are twisted by the turns
    /// since the start pose that the pose tells: none.
    Eigen::VectorXd at(const Moment& moment) const;
    /// A row per time. Turns of rotational springs are counted along the rows, which must lie less than half
    /// a turn of any spring apart. Turns of angles are followed from row to row by their rates.
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
    double effort = 0.0;  ///< of a driver, along what it prescribes: effort times rate is its power [N, N m]
};

/// Reactions of a motion; where redundant equations leave them open, the smallest.
struct Reactions {
    std::vector<Reaction> reactions;  ///< of joints, then of drivers; none between two fixed bodies
    int open = 0;                     ///< independent reactions that can be added without any motion
    /// Part of M q̈ - Q that no reaction explains, relative; above `bound` the moment is none of a motion.
    double residual = 0.0;
    double bound = 0.0;  ///< what rounding can make of the residual
};
/// @throws std::invalid_argument if a moving body has no mass
Reactions reactions_at(const Mechanism& mechanism, const Moment& moment);

}  // namespace JOINTWISE_ABI
}  // namespace jointwise
