#pragma once

#include <array>
#include <vector>

#include "core/kinematics/proof/proved_equations.hpp"

/// Parts of a mechanism whose poses follow from those of earlier parts: a crank from the ground and its
/// driver, then coupler and rocker, and so on. A proof of a part needs only the inverse of its own equations.
namespace jw {

/// Block of coordinates of a mechanism: r or p of a moving body, or a θ. It has `size` columns, which are
/// compared in units of `scale`.
struct Coordinates {
    int body = -1;
    int theta = -1;
    int size = 0;
    double scale = 1.0;
};

/// Coordinates of a system, numbered: r and p of each moving body, then each θ.
class CoordinateTable {
public:
    explicit CoordinateTable(const System& system);

    const std::vector<Coordinates>& all() const { return all_; }
    /// Index of r of a body (that of p follows), -1 if it is fixed.
    int of_body(int body) const { return of_body_[at(body)]; }
    int of_theta(int theta) const { return of_theta_[at(theta)]; }
    /// Indices of the blocks of an equation in this table: -1 for a fixed body, and if θ is not an unknown.
    std::array<int, kBlocks> blocks_of(const ProvedEquation& equation) const;

private:
    std::vector<Coordinates> all_;
    std::vector<int> of_body_;
    std::vector<int> of_theta_;
};

/// Jacobian of an equation in scaled rows and columns, by blocks; a block that does not exist is empty.
struct EquationJacobian {
    std::array<MatrixX, kBlocks> blocks;
};

/// Calls f(k, block) for each block of an equation whose coordinate has a number k ≥ 0.
template <class F>
void for_each_block(const std::array<int, kBlocks>& numbers, const EquationJacobian& jacobian, F&& f) {
    for (std::size_t b = 0; b < kBlocks; ++b) {
        if (numbers[b] >= 0 && jacobian.blocks[b].size() > 0) { f(numbers[b], jacobian.blocks[b]); }
    }
}

void compute_jacobian(
    const ProvedEquation& equation, const BodyKinematics<ModifiedEulerParameters>& i,
    const BodyKinematics<ModifiedEulerParameters>& j, const Theta& theta, double length,
    EquationJacobian& out);

/// Part of a mechanism.
struct Part {
    std::vector<int> unknowns;   ///< indices in the table
    std::vector<int> inputs;     ///< coordinates of earlier parts that its equations depend on
    std::vector<int> equations;  ///< indices of its equations
    int rows = 0;
    int columns = 0;
    int rank = 0;  ///< less than the columns if something is left free
    /// True if a motion that is left free moves several bodies together, so that drivers do not determine
    /// their poses. A rod that turns about itself moves alone.
    bool is_underdriven = false;

    int free_columns() const { return columns - rank; }
};

/// Columns of the largest part that is proved, 40 bodies: the work grows with their cube. The rank of a
/// larger one is not determined.
inline constexpr int kMostProvedColumns = 280;

/// Divides the coordinates into parts at a pose with these Jacobians: single bodies, pairs and groups of
/// three with as many independent equations as unknowns. The rest forms parts of bodies that equations link.
std::vector<Part> find_parts(
    const CoordinateTable& table, const std::vector<ProvedEquation>& equations,
    const std::vector<EquationJacobian>& jacobians);

/// Least pivot of a row that counts as independent, relative to the largest.
inline constexpr double kIndependent = 1e-9;

}  // namespace jw
