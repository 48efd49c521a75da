#pragma once

#include <vector>

#include "core/equations/link_equations.hpp"
#include "core/motion/loads.hpp"
#include "core/motion/motion_equations.hpp"
#include "core/numerics/flatten.hpp"

namespace jw {

using Kinematics6 = BodyKinematics<OmegaLocal>;

/// Moving body: its index in the mechanism, its M and M⁻¹.
struct MovingBody {
    int body = 0;
    double mass = 0.0;
    double inverse_mass = 0.0;
    Mat3 J = Mat3::Zero();
    Mat3 inverse_J = Mat3::Zero();
};

/// Node of the graph: a link with its equations, its bodies and the kept rows.
struct Node {
    Link link;
    int moving_i = -1;  ///< index among the moving bodies, -1 for a fixed one
    int moving_j = -1;
    unsigned kept = 0;  ///< bit r: row r is kept
};

/// Rows of the links of a mechanism, evaluated into the places that BlockEquations<B> gives them. The
/// evaluation is the same for every B, and it is by far the largest part of the code: it is compiled once,
/// with B as a number (`width`).
class LinkRows {
protected:
    LinkRows(const Centroidal& scene, std::vector<Link> links, const Baumgarte& baumgarte, int width);
    ~LinkRows() = default;

    static bool has(unsigned rows, int row) { return ((rows >> row) & 1U) != 0; }

    /// Sets the bodies' kinematics; for Content::motion, their velocities, too.
    JW_FLATTEN void set_bodies(Content content, const double* y);
    /// Evaluates Φ, Φq and ν of every link; for Content::motion, γ, too.
    JW_FLATTEN void evaluate_links(Content content, double t);
    void tell_turns_at(Turns turns, double t, const double* y);

    std::size_t width_;  ///< B: places for the rows of a link
    Baumgarte baumgarte_;
    std::vector<MovingBody> moving_;
    std::vector<int> order_of_body_;
    std::vector<Node> nodes_;
    std::vector<Kinematics6> bodies_;  ///< kinematics of all bodies, fixed ones included
    std::vector<double> j_;            ///< Jᵀ of every side, 6 x B row-major
    std::vector<double> phi_;          ///< B numbers per link, like the next two
    std::vector<double> nu_;
    std::vector<double> gamma_;
    bool counts_turns_ = false;

private:
    template <class Jet>
    void write_jacobian(std::size_t n, const LinkEquation& equation, const Jet& jet);
};

}  // namespace jw
