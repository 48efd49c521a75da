#include "core/motion/block/block_equations.hpp"

#include <bit>
#include <limits>

namespace jw {

namespace {

/// Neighbours of every node: nodes that share a moving body with it.
std::vector<std::vector<int>> neighbours_of(const std::vector<Node>& nodes, std::size_t bodies) {
    std::vector<std::vector<int>> on_body(bodies);
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        for (const int moving : {nodes[n].moving_i, nodes[n].moving_j}) {
            if (moving >= 0) { on_body[at(moving)].push_back(static_cast<int>(n)); }
        }
    }
    std::vector<std::vector<int>> neighbours(nodes.size());
    for (const std::vector<int>& group : on_body) {
        for (const int a : group) {
            for (const int b : group) {
                auto& list = neighbours[at(a)];
                if (a != b && std::ranges::find(list, b) == list.end()) { list.push_back(b); }
            }
        }
    }
    return neighbours;
}

/// Pivot below which iterative refinement recovers digits: reactions are wrong by 1e-16 / pivot, and the
/// accelerations that they give a light body by 1e-16 / pivot². An error of 1e-8 was seen at 7e-4.
constexpr double kFewDigitsAreLost = 1e-3;

}  // namespace

template <int B>
BlockEquations<B>::BlockEquations(
    const Centroidal& scene, std::vector<Link> links, const Baumgarte& baumgarte)
    : LinkRows(scene, std::move(links), baumgarte, B),
      scene_(&scene),
      matrix_(structure_),
      forces_(scene.mechanism.bodies.size()),
      six_(6 * moving_.size(), 0.0),
      extent_(extent(scene.mechanism)) {
    build_structure();
    w_.assign(2 * nodes_.size() * kSide, 0.0);
    for (std::vector<double>* v : {&lambda_, &row_size_}) { v->assign(nodes_.size() * B, 0.0); }
    inverse_unit_.assign(nodes_.size() * B, 1.0);
}

template <int B>
void BlockEquations<B>::build_structure() {
    structure_ = BlockStructure(neighbours_of(nodes_, moving_.size()));
    matrix_ = BlockMatrix<B>(structure_);
    std::vector<std::vector<int>> sides(moving_.size());
    for_each_side([&](std::size_t, int side, std::size_t moving) { sides[moving].push_back(side); });
    for (const std::vector<int>& group : sides) {
        for (const int a : group) {
            for (const int b : group) {
                const int node_a = a / 2;
                const int node_b = b / 2;
                if (structure_.position(node_a) > structure_.position(node_b)) { continue; }
                products_.push_back({structure_.block_of(node_a, node_b), a, b});
            }
        }
    }
}

template <int B>
void BlockEquations<B>::weigh(Metric metric) {
    const bool by_mass = metric == Metric::mass;
    const Mat3 geometric_J = Mat3::Identity() / (extent_ * extent_);
    for_each_side([&](std::size_t, int side, std::size_t moving) {
        const MovingBody& body = moving_[moving];
        const double inverse_mass = by_mass ? body.inverse_mass : 1.0;
        const Mat3& inverse_J = by_mass ? body.inverse_J : geometric_J;
        const double* j = &j_[side_at(side)];
        double* out = &w_[side_at(side)];
        for (int row = 0; row < B; ++row) {
            for (int k = 0; k < 3; ++k) { out[row * 6 + k] = inverse_mass * j[k * B + row]; }
            for (int k = 0; k < 3; ++k) {
                out[row * 6 + 3 + k] = j[3 * B + row] * inverse_J(0, k) + j[4 * B + row] * inverse_J(1, k) +
                                       j[5 * B + row] * inverse_J(2, k);
            }
        }
    });
}

template <int B>
void BlockEquations<B>::form_matrix() {
    matrix_.set_zero();
    for (const Product& product : products_) {
        kernels::add_product<B, 6>(
            matrix_.block(product.block), &w_[side_at(product.w_side)], &j_[side_at(product.j_side)]);
    }
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        double* diagonal = matrix_.block(static_cast<int>(n));
        for (int row = 0; row < B; ++row) {
            if (!has(nodes_[n].kept, row)) { diagonal[row * B + row] = 1.0; }
            row_size_[n * B + at(row)] = diagonal[row * B + row];
        }
    }
}

template <int B>
void BlockEquations<B>::factor_in_metric() {
    weigh(masses_apart_ ? Metric::geometry : Metric::mass);
    form_matrix();
    matrix_.factor();
}

template <int B>
double BlockEquations<B>::smallest_pivot() const {
    double largest = 0.0;
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        for (int row = 0; row < B; ++row) {
            const double inverse =
                row_size_[n * B + at(row)] * matrix_.inverse_pivot(static_cast<int>(n), row);
            // a pivot that rounding made negative counts as 0
            largest = std::max(largest, inverse > 0.0 ? inverse : std::numeric_limits<double>::infinity());
        }
    }
    return largest > 0.0 ? 1.0 / largest : 1.0;
}

template <int B>
void BlockEquations<B>::subtract_products(const double* x, double* b) const {
    for_each_side([&](std::size_t n, int side, std::size_t moving) {
        const double* j = &j_[side_at(side)];
        const double* six = x + 6 * moving;
        double* rows = b + n * B;
        for (int k = 0; k < 6; ++k) {
            for (int row = 0; row < B; ++row) { rows[row] -= j[k * B + row] * six[k]; }
        }
    });
}

template <int B>
void BlockEquations<B>::add_reactions(const double* lambda, double* x) const {
    for_each_side([&](std::size_t n, int side, std::size_t moving) {
        const double* weights = &w_[side_at(side)];
        double* six = x + 6 * moving;
        for (int row = 0; row < B; ++row) {
            for (int k = 0; k < 6; ++k) { six[k] += weights[row * 6 + k] * lambda[n * B + at(row)]; }
        }
    });
}

template <int B>
void BlockEquations<B>::set_lambda(const std::vector<double>& numbers) {
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        for (int row = 0; row < B; ++row) {
            const std::size_t k = n * B + at(row);
            lambda_[k] = has(nodes_[n].kept, row) ? numbers[k] : 0.0;
        }
    }
}

template <int B>
RowsVerdict BlockEquations<B>::evaluate(double t, const double* y, double* y_dot) {
    set_bodies(Content::motion, y);
    evaluate_links(Content::motion, t);
    factor_in_metric();
    evaluate_forces(t, y);
    const double pivot = smallest_pivot();
    constrain_accelerations(pivot < kFewDigitsAreLost ? 2 : 1);
    write_rates(y_dot);
    return {pivot, largest(phi_, true), largest(phi_, false)};
}

template <int B>
RowsVerdict BlockEquations<B>::evaluate_driven(double t, const double* y, double* y_dot) {
    set_bodies(Content::motion, y);
    evaluate_links(Content::motion, t);
    std::ranges::fill(six_, 0.0);
    constrain_accelerations(1);
    meet(gamma_, size_of_six());
    write_rates(y_dot);
    return {smallest_pivot(), largest(phi_, true), largest(phi_, false)};
}

template <int B>
void BlockEquations<B>::write_rates(double* y_dot) const {
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        const Kinematics6& body = bodies_[at(moving_[m].body)];
        vec3(body_numbers(y_dot, m)) = body.r_dot;
        vec4(body_numbers(y_dot, m) + 3) = body.p_dot;
    }
    write_accelerations(y_dot);
}

template <int B>
void BlockEquations<B>::constrain_accelerations(int passes) {
    if (masses_apart_) {
        solve_by_pivoting();
        return;
    }
    for (int pass = 0; pass < passes; ++pass) {
        set_lambda(gamma_);
        subtract_products(six_.data(), lambda_.data());
        matrix_.solve(lambda_.data());
        add_reactions(lambda_.data(), six_.data());
    }
}

template <int B>
void BlockEquations<B>::write_accelerations(double* y_dot) const {
    for (std::size_t m = 0; m < moving_.size(); ++m) {
        std::copy_n(&six_[6 * m], 6, body_numbers(y_dot, m) + 7);
    }
}

template <int B>
void BlockEquations<B>::refine(double* y_dot) {
    constrain_accelerations(1);
    write_accelerations(y_dot);
}

template <int B>
void BlockEquations<B>::set_driver(int driver, double f0, double f1) {
    for (Node& node : nodes_) {
        for (LinkEquation& equation : node.link.equations) {
            if (equation.driver != driver) { continue; }
            std::get<Driven>(equation.primitive).function.polynomial.assign({f0, f1});
        }
    }
}

template <int B>
int BlockEquations<B>::rows() const {
    int rows = 0;
    for (const Node& node : nodes_) { rows += node.link.rows; }
    return rows;
}

template <int B>
int BlockEquations<B>::rows_left_out() const {
    int out = 0;
    for (const Node& node : nodes_) { out += node.link.rows - std::popcount(node.kept); }
    return out;
}

template class BlockEquations<3>;
template class BlockEquations<5>;
template class BlockEquations<6>;

std::unique_ptr<DrivableEquations> block_equations(const Centroidal& centroidal, const Baumgarte& baumgarte) {
    std::vector<Link> links = with_drivers_joined(links_of(centroidal.mechanism));
    int most = 0;
    for (const Link& link : links) { most = std::max(most, link.rows); }
    // spherical joints; revolute and prismatic joints; everything else
    if (most <= 3) { return std::make_unique<BlockEquations<3>>(centroidal, std::move(links), baumgarte); }
    if (most <= 5) { return std::make_unique<BlockEquations<5>>(centroidal, std::move(links), baumgarte); }
    return std::make_unique<BlockEquations<6>>(centroidal, std::move(links), baumgarte);
}

}  // namespace jw
