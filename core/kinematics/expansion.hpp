#pragma once

#include <array>
#include <vector>

#include "core/jets/power_series.hpp"
#include "core/kinematics/proof/proved_step.hpp"

/// Power series of a path along a velocity. The independent equations give its coefficients, order by order;
/// the other equations may be violated.
namespace jw {

/// Coefficient of the equation that is violated most; 0 if rounding and the error of the pose explain it.
struct Missed {
    int order = 0;
    double value = 0.0;  ///< in units of the equation
    int equation = 0;    ///< of proved_equations
};
using Misfits = std::array<Missed, kOrders>;

class Expansion {
public:
    /// @param system drivers stand still at time 0; must outlive this
    Expansion(const System& system, const State& state, const Motion& velocity);

    /// False if all equations are independent, or if there are more than kMostProvedColumns columns.
    bool has_dependent_rows() const { return static_cast<int>(independent_.size()) < rows_count_; }
    /// Number of free motions of the bodies that move and of those that are linked to them.
    Eigen::Index freedoms() const { return columns_ - static_cast<Eigen::Index>(independent_.size()); }

    Eigen::Index columns() const { return columns_; }
    /// The velocity, in units of the coordinates.
    VectorX velocity() const;
    /// Part of a velocity that the independent equations leave free.
    VectorX free_part(const VectorX& x) const { return x - Q_ * (Q_.transpose() * x); }

    /// Misfits along a velocity of size 1, one per order: entry 0 is that of the pose, entry 1 is not used.
    Misfits expand(const VectorX& first);

    const ProvedStep& step() const { return step_; }

private:
    /// Rows of an equation, from `first` on: `turn`ᵀ times the rows of its primitive.
    struct Rows {
        int equation = 0;
        int first = 0;
        MatrixX turn;
    };

    void find_linked();
    bool is_linked(int equation) const;
    void order_equations();
    MatrixX jacobian_of(int equation);
    void choose_independent();
    void add_row(int row);
    BodyKinematics<PowerSeries> body(int index) const;
    void evaluate(int order);
    VectorX solve(int order);
    Missed worst(int order, const VectorX& own) const;

    ProvedStep step_;
    std::vector<int> first_column_;  ///< per coordinate, -1 where it is not linked to moving bodies
    int columns_ = 0;
    double tolerance_;
    std::vector<Rows> rows_;
    int rows_count_ = 0;
    MatrixX J_;
    std::vector<bool> is_independent_;
    // J of the independent rows is L Qᵀ
    std::vector<int> independent_;
    MatrixX Q_;
    MatrixX L_;
    double least_pivot_ = 1.0;
    std::array<VectorX, kOrders> x_;  ///< coefficients of the path, in units of the coordinates
    VectorX value_;                   ///< per row: coefficient of Φ
    VectorX size_;                    ///< per row: sum of the sizes of its terms
};

/// Least speed of a moving body, relative to the largest: below it, a null vector may be rounding.
inline constexpr double kLeastSpeed = 1e-6;

}  // namespace jw
