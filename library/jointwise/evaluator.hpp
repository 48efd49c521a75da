#pragma once

#include "jointwise/trajectory.hpp"

/// The functions of analysis.hpp for many poses of one mechanism.
namespace jointwise {
inline namespace JOINTWISE_ABI {

/// Equations at all times of a motion, one row per time.
struct EquationsTable {
    Table phi;       ///< [times x rows]
    Table jacobian;  ///< [times x (rows columns)]: Φq of a time, row by row
    Table nu;        ///< [times x rows]
    Table gamma;     ///< [times x rows]
};

/// Equations of one mechanism at many poses: the constructor prepares structure and memory once. Results are
/// those of the functions with the same names. Two threads must not use an Evaluator at the same time.
class Evaluator {
public:
    /// Uses the mechanism as it is now; later changes have no effect. Of p1 and p2, it uses the rows that the
    /// rule keeps at the mechanism's start pose.
    explicit Evaluator(
        const Mechanism& mechanism, Coordinates coordinates = Coordinates::modified_euler_parameters);
    ~Evaluator();
    Evaluator(Evaluator&&) noexcept;
    Evaluator& operator=(Evaluator&&) noexcept;

    int rows() const;
    int columns() const;
    /// "hinge.p1.y", one per row, for the rows chosen now.
    const std::vector<std::string>& row_names() const;
    /// "crank.x", "crank.omega_local.z", "jack.angle": the coordinate or the velocity of each column.
    std::vector<std::string> column_names() const;

    /// Applies the rule of slide 5 at a pose; a row is kept until its condition becomes bad. @return true if
    /// the rows have changed
    bool choose_rows(const Pose& pose);

    /// Φ, Φq, ν and γ with the rows chosen now.
    /// @param out its memory is used again if it has the right size
    void equations_at(const Pose& pose, const Rates& velocities, Equations& out);
    /// Φ, Φq, ν and γ at all times of a motion, with the rows chosen before.
    EquationsTable equations_along(const Trajectory& trajectory);
    /// Only Φ. @param out [rows]
    void phi_at(const Pose& pose, Eigen::VectorXd& out);
    /// Velocities (or accelerations) in the order of the columns: ṙ and ṗ, ω′ or ω of every moving body, then
    /// θ̇.
    Eigen::VectorXd columns_of(const Pose& pose, const Rates& rates) const;

    Pose assemble(const Pose& estimate, double t);
    Rank rank_at(const Pose& pose);
    Rates velocities_at(const Pose& pose);
    Rates accelerations_at(const Pose& pose, const Rates& velocities);

private:
    struct Inside;
    std::unique_ptr<Inside> inside_;
};

}  // namespace JOINTWISE_ABI
}  // namespace jointwise
