#pragma once

#include <vector>

#include "core/motion/block/link_rows.hpp"
#include "core/motion/forces.hpp"
#include "core/motion/motion_equations.hpp"
#include "core/numerics/block_matrix.hpp"

/// Equations of motion over the graph of joints: Φq M⁻¹ Φqᵀ is a block-sparse matrix with one block of B x B
/// for every pair of links that share a moving body. Included only by the sources that implement it.
namespace jw {

/// One product W Jᵀ of Φq M⁻¹ Φqᵀ; the index of a side is 2 node (+ 1 for body j).
struct Product {
    int block = 0;
    int w_side = 0;
    int j_side = 0;
};

template <int B>
class BlockEquations final : public DrivableEquations, private LinkRows {
public:
    BlockEquations(const Centroidal& scene, std::vector<Link> links, const Baumgarte& baumgarte);

    int size() const override { return kNumbersPerBody * static_cast<int>(moving_.size()); }
    RowsVerdict evaluate(double t, const double* y, double* y_dot) override;
    double project(double t, double* y) override;
    double smallest_pivot() const override;
    bool choose_rows(double t, const double* y) override;
    void take_back_rows() override;
    void begin_turns(double t, const double* y) override { tell_turns_at(Turns::of_start, t, y); }
    void follow_turns(double t, const double* y) override { tell_turns_at(Turns::of_motion, t, y); }
    bool counts_turns() const override { return counts_turns_; }
    std::pair<double, double> violation(double t, const double* y) override;
    MatrixX free_motions(double t, const double* y) override;
    bool free_motion(
        double t, const double* y, std::span<const double> drawn, std::span<ProbedBody> bodies) override;
    void refine(double* y_dot) override;
    RowsVerdict evaluate_driven(double t, const double* y, double* y_dot) override;
    bool masses_are_apart() const override { return masses_apart_; }
    void forget_masses() override { forgets_masses_ = true; }
    bool rows_are_sound(double t, const double* y) override;
    void keep_pivots() override;
    double share_of_pivots() const override;
    void set_driver(int driver, double f0, double f1) override;
    int rows() const override;
    int rows_left_out() const override;

private:
    static constexpr int kSide = 6 * B;
    /// Offset of a side in j_ and w_.
    static std::size_t side_at(int side) { return static_cast<std::size_t>(side) * kSide; }
    /// Calls `f(n, side, moving)` for every side of node n whose body moves.
    template <class F>
    void for_each_side(F&& f) const {
        for (std::size_t n = 0; n < nodes_.size(); ++n) {
            const int side = 2 * static_cast<int>(n);
            if (nodes_[n].moving_i >= 0) { f(n, side, at(nodes_[n].moving_i)); }
            if (nodes_[n].moving_j >= 0) { f(n, side + 1, at(nodes_[n].moving_j)); }
        }
    }

    void build_structure();
    /// W = J M⁻¹ of every side. Metric::geometry replaces M by one without masses: a rotation counts as the
    /// displacement of a point one extent away.
    enum class Metric { mass, geometry };
    void weigh(Metric metric);
    void measure_units();
    struct RowOfNode {
        std::size_t node = 0;
        int row = 0;
        double square = 0.0;  ///< square of its size in the metric of geometry
    };
    void look_at_all_rows(double t, const double* y);
    void keep_independent_rows();
    int keep_rows_beyond(double least, std::vector<RowOfNode>& doubtful);
    void factor_kept_rows(const std::vector<double>& all);
    void keep_what_is_left(const std::vector<double>& all, const std::vector<RowOfNode>& doubtful);
    void take_out_rows();
    double along(const std::vector<double>& all, const RowOfNode& row, const double* x) const;
    double what_is_left_of(const std::vector<double>& all, RowOfNode& row);
    void strike_rows(int n, double* diagonal);
    void form_matrix();
    /// Pivot of a row divided by its own size.
    double pivot_of(std::size_t node, int row) const;
    /// Factors Φq M⁻¹ Φqᵀ of the links as last evaluated; in the metric of geometry where masses are far
    /// apart.
    void factor_in_metric();
    /// Determines whether Φq M⁻¹ Φqᵀ keeps its digits at the poses last set.
    void compare_masses(double t);
    /// Turns M⁻¹ Q of every body into its accelerations.
    void solve_by_pivoting();
    /// Largest |Φ| or |Φ̇|, each divided by the size of its equation, over the kept rows or over those left
    /// out.
    double largest(const std::vector<double>& numbers, bool kept) const;
    /// Sets λ to the numbers of the kept rows and to 0 for the others.
    void set_lambda(const std::vector<double>& numbers);
    void project_velocities(double* y);
    /// Largest of six_, with rotations unchanged and translations divided by the extent.
    double size_of_six() const;
    /// Adds M⁻¹ Φqᵀ λ to six_ until Φq six_ is `right` to rounding of numbers of this size.
    void meet(const std::vector<double>& right, double size);
    /// Adds M⁻¹ Φqᵀ λ to the accelerations so that Φq q̈ = γ.
    void constrain_accelerations(int passes);
    void write_rates(double* y_dot) const;
    void write_accelerations(double* y_dot) const;
    /// Computes M⁻¹ Q of every body.
    void evaluate_forces(double t, const double* y);
    /// b_node -= J x, with six numbers per moving body in x.
    void subtract_products(const double* x, double* b) const;
    /// x_body += Wᵀ λ
    void add_reactions(const double* lambda, double* x) const;

    const Centroidal* scene_;
    std::vector<unsigned> kept_before_;  ///< rows of every node before the last choice
    std::vector<Product> products_;
    BlockStructure structure_;
    BlockMatrix<B> matrix_;
    std::vector<BodyForce> forces_;  ///< loads on all bodies
    std::vector<double> w_;          ///< J M⁻¹ of every side, B x 6 row-major
    std::vector<double> lambda_;
    std::vector<double> inverse_unit_;  ///< 1 / change of every equation when bodies move by one extent
    std::vector<double> row_size_;      ///< diagonal of Φq M⁻¹ Φqᵀ
    std::vector<double> six_;           ///< six numbers per moving body: accelerations, displacements
    std::vector<double> kept_pivots_;   ///< reference of share_of_pivots, one per row
    double extent_ = 1.0;
    bool forgets_masses_ = false;
    bool masses_apart_ = false;         ///< light bodies carry heavy ones: see block_pivoting.cpp
    bool masses_apart_before_ = false;  ///< its value before the last choice of rows
};

}  // namespace jw
