#pragma once

#include <vector>

#include "core/equations/assembler.hpp"
#include "core/motion/forces.hpp"
#include "core/motion/motion_equations.hpp"
#include "core/motion/saddle_point.hpp"

/// Equations of motion as on the slides: one dense system in any of the four coordinate choices.
namespace jw {

/// | choice   | y of a body  | ṗ is       | M            | Q                      |
/// | -------- | ------------ | ---------- | ------------ | ---------------------- |
/// | (r, ω')  | r, p, ṙ, ω'  | ½ Lᵀ ω'    | m I, J'      | f, n' - ω̃'J'ω'         |
/// | (r, ω)   | r, p, ṙ, ω   | ½ Gᵀ ω     | m I, A J' Aᵀ | f, A (n' - ω̃'J'ω')     |
/// | (r, p)   | r, p, ṙ, ṗ   | integrated | m I, 4 LᵀJ'L | f, 2 Lᵀ (n' - ω̃'J'ω')  |
///
/// n - ω̃Jω is A (n' - ω̃'J'ω'); the component of Q along p, which 2 Lᵀ omits, goes into the λ of pᵀp = 1.
///
/// The rows are those of the mechanism as given, in the order of System. θ of a screw is not part of y: its
/// value follows from the poses, with turns counted from the last evaluation.
///
/// This is the implementation for teaching and reference: clear, O(n³), and it allocates.
/// @source slides 24 and 25; signs in docs/notation.md
template <class C>
class DenseEquations final : public MotionEquations {
public:
    /// Numbers of y per body: 13, or 14 where y holds ṗ.
    static constexpr int kNumbers = 10 + C::kAngular;

    /// `scene` must outlive this. Rows are chosen at its start pose.
    explicit DenseEquations(const Centroidal& scene, const Baumgarte& baumgarte = {});

    int size() const override { return kNumbers * bodies(); }
    int bodies() const override { return static_cast<int>(system_.moving_bodies().size()); }
    std::vector<NumberScale> scales() const override { return flat_scales(size(), kNumbers); }
    void to_flat(const double* y, double* flat) const override;
    void from_flat(const double* flat, double* y) const override;
    void derivatives(const double* y, const double* y_dot, double* out) const override;
    void state_of(const double* value, const double* rate, double* y) const override;
    RowsVerdict evaluate(double t, const double* y, double* y_dot) override;
    double project(double t, double* y) override;
    bool choose_rows(double t, const double* y) override;
    double smallest_pivot() const override { return saddle_point_.smallest_pivot(); }
    void take_back_rows() override;
    bool follow_rule(double t, const double* y) override;
    double most_turn() const override;
    std::pair<double, double> violation(double t, const double* y) override;
    void motion_of_bodies(
        double t, const double* y, const double* y_dot, std::span<ProbedBody> bodies) override;
    int rows() const override { return system_.rows(C::kNormalised); }
    int rows_left_out() const override { return rows() - static_cast<int>(saddle_point_.kept().size()); }

    /// Convert state and motion of the centroidal frames to y, and back.
    void pack(const State& state, const Motion& motion, double* y) const;
    void unpack(const double* y, State& state, Motion& motion) const;

    /// System, matrices and vectors of the last evaluation, and its solution.
    const System& system() const { return system_; }
    const MatrixX& mass_matrix() const { return mass_; }
    const MatrixX& jacobian() const { return assembler_.jacobian(); }
    const VectorX& force() const { return force_; }
    /// γ, with Baumgarte's terms.
    const VectorX& right_side() const { return right_; }
    const VectorX& acceleration() const { return acceleration_; }
    /// Multipliers, one per row; not unique where rows are left out, whose λ is 0.
    const VectorX& lambda() const { return lambda_; }
    /// Rows that the last solution used, the most independent first.
    const std::vector<int>& kept_rows() const { return saddle_point_.kept(); }

private:
    void flat_rates(const double* y, const double* y_dot, double* flat_dot) const;
    void read(const double* y);
    void find_thetas();
    void set_mass();
    void set_force(double t);
    void measure_rows();
    double largest(const VectorX& values) const;
    double largest_of_kept_rows(const VectorX& values) const;
    /// Newton's method in the metric of M. @return largest |Φ| of the kept rows before, divided by its size
    double correct_positions(double t);

    const Centroidal* scene_;
    Baumgarte baumgarte_;
    System system_;
    Assembler<C> assembler_;
    SaddlePoint saddle_point_;
    System system_before_;  ///< system with the rows from before the last choice
    std::vector<int> kept_before_;
    State state_;
    Motion motion_;
    VectorX velocity_;  ///< motion_ as columns
    std::vector<BodyKinematics<OmegaLocal>> bodies_;
    std::vector<BodyForce> forces_;
    MatrixX mass_;
    VectorX force_;
    VectorX right_;
    VectorX acceleration_;
    VectorX lambda_;
    VectorX inverse_size_;  ///< 1 / size of every equation
};

/// Dense equations in a coordinate choice known at run time only.
std::unique_ptr<MotionEquations> dense_equations(
    const Centroidal& scene, CoordinateChoice choice, const Baumgarte& baumgarte = {});

}  // namespace jw
