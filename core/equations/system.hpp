#pragma once

#include <bit>
#include <vector>

#include "core/equations/independent_rows.hpp"
#include "core/model/mechanism.hpp"

/// The equations of a part of a mechanism, with the origin of each row and the layout of rows and columns.
/// Structure is computed once; only the choice of p1 / p2 rows may change, between solves.
namespace jw {

/// A primitive of a joint, placed between two bodies.
struct Constraint {
    int joint = 0;
    Role role = Role::same_point;
    Primitive primitive;
    int body_i = 0;
    int body_j = 0;
    int theta = -1;          ///< index of the artificial coordinate, -1 if none
    int dropped = -1;        ///< component left out by its form, -1 if none
    unsigned taken_out = 0;  ///< bit k: component k is taken out by hand (Joint::without)
    int first_row = 0;
    int equations = 0;  ///< all of them, those without a row included
    double unit = 1.0;  ///< size of one equation in the scene's units; see System::row_unit

    /// Bit k: component k has no row.
    unsigned left_out() const { return taken_out | (dropped >= 0 ? 1U << dropped : 0U); }
    bool has_row(int component) const { return ((left_out() >> component) & 1U) == 0; }
    int rows() const { return equations - std::popcount(left_out()); }
};

/// Equation of a driver, one row.
struct DriverConstraint {
    int driver = 0;
    int theta = -1;
    int row = 0;
    double unit = 1.0;
};

/// Origin of a row: a constraint, a driver or the normalisation of a body.
struct RowOrigin {
    enum class Kind { constraint, driver, normalisation };
    Kind kind = Kind::constraint;
    int index = 0;      ///< into constraints(), drivers() or the mechanism's bodies
    int component = 0;  ///< equation of the primitive: 0, 1, 2
};

/// Joints and drivers that take part, by their index in the mechanism and in the order in which they were
/// added.
struct Selection {
    std::vector<int> joints;
    std::vector<int> drivers;
};
Selection everything(const Mechanism& mechanism);

class System {
public:
    /// `mechanism` must outlive the system.
    /// @throws std::invalid_argument for an index that is not in the mechanism
    System(const Mechanism& mechanism, Selection selection);

    const Mechanism& mechanism() const { return *mechanism_; }
    const Selection& selection() const { return selection_; }
    const std::vector<Constraint>& constraints() const { return constraints_; }
    const std::vector<DriverConstraint>& drivers() const { return drivers_; }
    const std::vector<int>& moving_bodies() const { return moving_bodies_; }
    const std::vector<int>& active_thetas() const { return active_thetas_; }
    double length_unit() const { return length_unit_; }

    /// Rows of joints and drivers; normalisation rows come after them.
    int rows() const { return static_cast<int>(origins_.size()); }
    int rows(bool normalised) const {
        return rows() + (normalised ? static_cast<int>(moving_bodies_.size()) : 0);
    }
    int columns(int angular) const {
        return (3 + angular) * static_cast<int>(moving_bodies_.size()) +
               static_cast<int>(active_thetas_.size());
    }
    /// First column of a body, -1 if it is fixed. `angular` = 4 for the (r, p) choices, else 3.
    int body_column(int body, int angular) const {
        const int order = order_of_body_[static_cast<std::size_t>(body)];
        return order < 0 ? -1 : (3 + angular) * order;
    }
    /// Column of an artificial coordinate, -1 if its joint is not part of the system.
    int theta_column(int theta, int angular) const {
        const int order = order_of_theta_[static_cast<std::size_t>(theta)];
        return order < 0 ? -1 : (3 + angular) * static_cast<int>(moving_bodies_.size()) + order;
    }

    RowOrigin origin(int row) const;
    /// Nominal size of a row: |s_i||s_j|, the scene's unit of length, ...; residuals and rows are divided by
    /// it before they are compared, so that long vectors and other length units do not change a verdict.
    double row_unit(int row) const;

    /// Applies the rule of slide 5 at `state` to every p1 / p2 under ParallelForm::rule. Where an equation is
    /// taken out by hand the first choice stays: the others no longer imply the one that the rule leaves out.
    /// @return true if a choice changed
    bool choose_rows(const State& state);
    /// Takes over the choices that the rule has made in another system, for constraints that both have.
    void inherit_rows(const System& other);

private:
    void add_joint(int joint, int theta);
    void number_rows();

    const Mechanism* mechanism_;
    Selection selection_;
    std::vector<Constraint> constraints_;
    std::vector<DriverConstraint> drivers_;
    std::vector<RowOrigin> origins_;
    std::vector<int> moving_bodies_;
    std::vector<int> order_of_body_;
    std::vector<int> active_thetas_;
    std::vector<int> order_of_theta_;
    double length_unit_ = 1.0;
};

}  // namespace jw
