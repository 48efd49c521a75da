#pragma once

#include "jointwise/analysis.hpp"

/// Motions as tables: one row per time, one column per number.
namespace jointwise {
inline namespace JOINTWISE_ABI {

/// Row-major: the numbers of one time lie together.
using Table = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A motion at ascending times, with the same numbers as a Moment per time.
struct Trajectory {
    Eigen::VectorXd t;       ///< [s]
    int bodies = 0;          ///< the ground included
    Table q;                 ///< r and p of every body, 7 columns each, then the angles of screws
    Table q_dot;             ///< ṙ and ω′ of every body, 6 columns each, then their rates
    Table q_ddot;            ///< r̈ and ω̇′, likewise
    Eigen::VectorXd energy;  ///< kinetic and potential [J]; 0 in `follow`

    int times() const { return static_cast<int>(t.size()); }
    /// The moment of one row. @throws std::invalid_argument if there is no such row
    Moment moment(int row) const;
};

/// Motions of `follow` and `simulate` (analysis.hpp) as a table, without storing moments in addition.
/// @param go_on  called before each time; false ends with NotReached
Trajectory follow_trajectory(
    const Mechanism& mechanism, const std::vector<double>& times, const std::function<bool()>& go_on = {});
Trajectory simulate_trajectory(
    const Mechanism& mechanism, const std::vector<double>& times, const Simulation& settings = {});

}  // namespace JOINTWISE_ABI
}  // namespace jointwise
