#pragma once

#include <vector>

#include "core/equations/link_equations.hpp"
#include "core/jets/coordinates.hpp"
#include "core/motion/forces.hpp"
#include "core/motion/motion_equations.hpp"
#include "core/motion/tree/articulated_tree.hpp"
#include "core/numerics/envelope_matrix.hpp"

/// Equations of motion in joint coordinates: q̇ = B u with u the velocities of a tree of joints, whose
/// constraints hold identically. Loops are cut; the joints of the cuts remain equations, as drivers do.
///
///   Bᵀ M B u̇ - (Φq B)ᵀ λ = Bᵀ (Q - M Ḃ u),   Φq B u̇ = γ - Φq Ḃ u
///
/// With Bᵀ M B = F D Fᵀ (articulated_tree.hpp) and E = Φq B F⁻ᵀ, one row per equation of a loop:
///
///   E D⁻¹ Eᵀ λ = γ - Φq Ḃ u - E D⁻¹ e,   e = F⁻¹ Bᵀ (Q - M Ḃ u),   u̇ = F⁻ᵀ D⁻¹ (e + Eᵀ λ)
///
/// A row of E has entries for the joints of its own loop and of the path from there to the ground; the matrix
/// of λ couples rows that share a joint.
/// @source q̇ = B u: Nikravesh ch. 13, velocity transformation
namespace jw {

/// Equations of motion over a joint tree.
class TreeEquations final : public MotionEquations {
public:
    /// @param scene must outlive this
    /// @param start flat; it satisfies the constraints
    TreeEquations(
        const Centroidal& scene, const std::vector<double>& start, Registers registers = widest_registers());

    int size() const override { return joints().positions() + joints().velocities(); }
    int bodies() const override { return static_cast<int>(moving_.size()); }
    std::vector<NumberScale> scales() const override;
    void to_flat(const double* y, double* flat) const override;
    /// Valid only at the start pose; velocities are the nearest that the tree allows, in the metric of M.
    void from_flat(const double* flat, double* y) const override;
    int interpolated() const override { return joints().positions(); }
    void derivatives(const double* y, const double* y_dot, double* out) const override;
    void state_of(const double* value, const double* rate, double* y) const override;
    void flat_of(const double* value, const double* rate, double* flat) const override;

    RowsVerdict evaluate(double t, const double* y, double* y_dot) override;
    double project(double t, double* y) override;
    bool choose_rows(double t, const double* y) override;
    void take_back_rows() override;
    void begin_turns(double t, const double* y) override { tell_turns_at(Turns::of_start, t, y); }
    void follow_turns(double t, const double* y) override { tell_turns_at(Turns::of_motion, t, y); }
    bool counts_turns() const override { return counts_turns_; }
    double smallest_pivot() const override { return smallest_pivot_; }
    std::pair<double, double> violation(double t, const double* y) override;
    int rows() const override { return static_cast<int>(rows_.size()); }
    int rows_left_out() const override { return static_cast<int>(rows_.size() - kept_.size()); }

    void motion_of_bodies(
        double t, const double* y, const double* y_dot, std::span<ProbedBody> bodies) override;
    int velocities() const override { return joints().velocities(); }
    bool free_motion(
        double t, const double* y, std::span<const double> drawn, std::span<ProbedBody> bodies) override;

    /// Estimated number of products that the rows of loops add to an evaluation, if the share `kept` of them
    /// is kept. Every row of nested loops on moving bodies affects all joints down to the ground.
    double products_of_rows(double kept) const;

    const JointTree& joints() const { return tree_.joints(); }

private:
    using Node = ArticulatedTree::Node;
    using Metric = ArticulatedTree::Metric;
    /// Row of a cut joint or a driver, with the wrenches of a unit λ on its two bodies.
    struct Row {
        int node_i = 0;
        int node_j = 0;
        std::vector<int> path;    ///< indices in u where it has entries
        std::size_t first_e = 0;  ///< offset of its numbers in e_of_rows_ and in e_by_D_
        Six on_i;                 ///< wrench at the root of the node
        Six on_j;
        double phi = 0.0;
        double rate = 0.0;  ///< Φq q̇ - ν
        double gamma = 0.0;
        double inverse_unit = 1.0;  ///< 1 / change when bodies move by one extent
        double size = 1.0;          ///< diagonal entry of Φq M⁻¹ Φqᵀ, for unconstrained bodies
    };
    /// Rows of one primitive.
    struct Group {
        const Link* link;
        const LinkEquation* equation;
        int first_row;
    };
    /// One product of E D⁻¹ Eᵀ.
    struct Product {
        std::size_t target;
        std::size_t e;
        std::size_t e_by_D;
    };

    /// Computes poses and velocities of the nodes at y; results of the last evaluation are lost.
    void place(const double* y) const;
    /// True if the nodes hold the results of `evaluate` at y.
    bool is_evaluated_at(double t, const double* y) const;
    /// Ensures that the nodes hold the results of `evaluate` at y.
    void stay_at(double t, const double* y);
    void set_bodies(const double* y);
    void tell_turns_at(Turns turns, double t, const double* y);
    void write_rates(const double* y, double* y_dot) const;
    Six at_root(int node, const Mat3& A, const Eigen::Matrix<double, 1, 6>& block) const;
    void evaluate_rows(double t, const std::vector<Group>& groups);
    void evaluate_rows_of(const Group& group, double t);
    void measure_rows();
    /// Computes E and E D⁻¹ of these rows.
    void respond(const std::vector<int>& rows);
    /// Chooses independent rows from the last responses of all rows.
    std::vector<int> independent_rows() const;
    void keep(std::vector<int> rows);
    /// Forms and factors E D⁻¹ Eᵀ of the kept rows.
    void factor_rows();
    double along_row(const Row& row) const;
    /// Solves for λ from the right sides in lambda_, and adds Eᵀ λ to e.
    void add_answer_of_rows();
    /// Computes the change of u that cancels `number` in the kept rows.
    void take_out(double Row::*number);
    double largest_of_kept_rows(double Row::*number) const;
    void displace(double* y) const;
    void add_velocities(double* y) const;

    const Centroidal* scene_;
    double extent_;
    std::vector<int> moving_;
    // workspace of conversions and evaluations; no call relies on the results of another
    mutable ArticulatedTree tree_;
    mutable std::vector<double> y_;
    std::vector<Link> links_;
    std::vector<Row> rows_;
    std::vector<Group> groups_;
    std::vector<int> kept_;
    std::vector<int> kept_before_;
    std::vector<Group> kept_groups_;                  ///< groups with a kept row
    std::vector<BodyKinematics<OmegaLocal>> bodies_;  ///< kinematics of all bodies, fixed ones included
    std::vector<int> looked_at_;                      ///< moving bodies that loads and cut joints refer to
    std::vector<bool> needs_motion_;                  ///< bodies of springs and cut joints
    bool needs_p_ = false;                            ///< whether a driver prescribes one of e0 ... e3
    bool counts_turns_ = false;                       ///< whether the equations contain screws
    std::vector<BodyForce> forces_;
    std::vector<double> e_of_rows_;
    std::vector<double> e_by_D_;
    std::vector<Product> products_;
    EnvelopeMatrix matrix_;
    std::vector<double> lambda_;
    double smallest_pivot_ = 1.0;
    /// True if the nodes hold the results of the evaluation at the time and y below.
    mutable bool is_evaluated_ = false;
    std::vector<double> evaluated_y_;
    double evaluated_t_ = 0.0;
    std::vector<double> evaluated_y_dot_;
};

}  // namespace jw
